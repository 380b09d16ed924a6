#!/usr/bin/env bash
# Takes the Debian packages of a build tree apart into a directory, and uses what is there as if it were a machine's root:
# runs the program, builds and runs programs in C and C++ by pkg-config and CMake, and looks at what the packages say.
#
#   tests/package/run.sh <build tree>
set -euo pipefail
tree=$(realpath "$1")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
source_dir=$(realpath "$here/../..")
root=$tree/root
out=$tree/consumers
rm -rf "$root" "$out"
mkdir -p "$root" "$out"

version=$(sed -n 's/^ *VERSION \([0-9]*\.[0-9]*\.[0-9]*\)$/\1/p' "$source_dir/CMakeLists.txt" | head -1)
soversion=${version%.*}
fail() { echo "tests/package: $*" >&2; exit 1; }

grep -q "^## $version" "$source_dir/CHANGELOG.md" || fail "CHANGELOG.md has no section for $version"
architecture=$(dpkg --print-architecture)
for package in "libgraze$soversion" libgraze-dev graze python3-graze; do
  file=$tree/${package}_${version}_$architecture.deb
  [[ -f $file ]] || fail "there is no $file"
  [[ $(dpkg-deb --field "$file" Version) == "$version" ]] || fail "$file has another version"
  dpkg-deb --field "$file" Package Version Depends Installed-Size
  dpkg -x "$file" "$root"
  [[ -f $root/usr/share/doc/$package/copyright ]] || fail "$package has no copyright"
done
dpkg-deb --field "$tree/libgraze${soversion}_${version}_$architecture.deb" Depends | grep -q libstdc++6 ||
  fail "the library does not say that it needs libstdc++6"
dpkg-deb --field "$tree/libgraze-dev_${version}_$architecture.deb" Depends | grep -q "libgraze$soversion (= $version)" ||
  fail "libgraze-dev does not ask for its own library"

lib=$(dirname "$(find "$root/usr/lib" -name "libgraze.so.$version")")
export LD_LIBRARY_PATH=$lib
# Nothing of the build tree is named, and nothing is missing.
if grep -rl --include='*.cmake' --include='*.pc' "$tree" "$root" | grep .; then fail "these files name the build tree"; fi
for binary in "$root/usr/bin/graze" "$lib/libgraze.so.$version"; do
  if ldd "$binary" | grep "not found"; then fail "$binary lacks a library"; fi
done

"$root/usr/bin/graze" --version | grep -q "$version" || fail "the program has another version"
"$root/usr/bin/graze" collide "$source_dir/examples/scenes/demo.gltf" >"$out/collide.txt"
[[ -s $out/collide.txt ]] || fail "the program says nothing of the demo scene"

# The page of the Python package, example by example, with no graze on the path but the one of the packages.
dpkg-deb --field "$tree/python3-graze_${version}_$architecture.deb" Depends | grep -q python3-numpy ||
  fail "python3-graze does not ask for NumPy"
export PYTHONDONTWRITEBYTECODE=1
env -u LD_LIBRARY_PATH -C "$out" PYTHONPATH="$root/usr/lib/python3/dist-packages" /usr/bin/python3 - "$root" "$version" \
  "$source_dir/docs/python.md" <<'PYTHON' || fail "python3-graze does not work"
import doctest, importlib.metadata, sys

import graze
from graze import plane

root, version, page = sys.argv[1:]
assert graze.__file__.startswith(root) and plane.__file__.startswith(root), graze.__file__
assert graze.__version__ == importlib.metadata.version("graze") == version
result = doctest.testfile(page, module_relative=False)
assert result.attempted > 15 and result.failed == 0
PYTHON

consumer=$source_dir/tests/consumer
export PKG_CONFIG_PATH=$lib/pkgconfig
make -s -C "$consumer" OUT="$out/by_pkg_config"
"$out/by_pkg_config" && "$out/by_pkg_config_c"
cmake -S "$consumer" -B "$out/cmake" -Dgraze_ROOT="$root/usr" >"$out/cmake.txt"
cmake --build "$out/cmake" >>"$out/cmake.txt"
for program in consumer consumer_c consumer_shared consumer_c_shared; do "$out/cmake/$program"; done
echo "tests/package: packages of version $version work from $root"
