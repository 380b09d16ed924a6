#!/usr/bin/env bash
# Installs the Debian 12 packages that one part of Graze needs, and only those that are missing.
#
#   scripts/setup.sh demo|test|bench|fuzz|lint|arm|wasm|windows|abi|package|python|lab|site|mpi|npm [more groups...]
#   scripts/setup.sh --list <group>...        print the packages, install nothing
#
# The second run finds everything in place: it then needs neither root nor network and takes milliseconds, so that
# the Makefile can call it before every build. GRAZE_NO_SETUP=1 skips it (other distributions, locked-down machines).
set -euo pipefail

# The tools that build the library itself; every group starts from these.
base=(g++ make cmake ninja-build pkg-config)

# What the command-line program adds: scenes (tinygltf, and tinyxml2 for drawings), JSON, arguments, formatting, and the
# server of `graze view`.
demo=(libtinygltf-dev libtinyxml2-dev nlohmann-json3-dev libcli11-dev libfmt-dev libcpp-httplib-dev)

# GoogleTest and the property tests of RapidCheck.
test=(libgtest-dev librapidcheck-dev)

# oneTBB, whose adaptor is built wherever it is found and tested with the rest.
threads=(libtbb-dev)

# Google Benchmark, what reads the options, and the libraries that we measure ourselves against.
bench=(libbenchmark-dev libcli11-dev libbullet-dev libode-dev libfcl-dev libccd-dev libbox2d-dev libeigen3-dev libembree-dev)

# libFuzzer comes with clang; its runtime is only a recommendation of the clang package, hence named here. lld links what
# has sanitizers in a fifth of the time.
fuzz=(clang libclang-rt-14-dev lld)

lint=(clang clang-format clang-tidy)

# Other processors: a compiler for them and what runs their programs here.
arm=(g++-aarch64-linux-gnu qemu-user)
wasm=(emscripten)

# Windows: a compiler with threads of POSIX, GoogleTest's sources, since its library is Linux's, and what runs programs.
windows=(g++-mingw-w64-x86-64-posix googletest wine wine64)

# The npm package: JSON for the query protocol, where it is tested, and what checks its types. What npm packs is a tarball,
# made without npm.
npm=(emscripten nlohmann-json3-dev nodejs chromium-headless-shell node-typescript)

# What compares the C interface with the recorded one.
abi=(gcc abigail-tools)

# What takes packages apart and computes what they depend on, and what the Python module is built with.
package=(dpkg-dev fakeroot file python3-dev pybind11-dev python3-numpy)

# The Python package: the interpreter's headers, what writes the module, and what its tests and example use.
python=(python3-dev pybind11-dev python3-numpy python3-pip python3-venv python3-pytest python3-matplotlib)

# The lab: what builds it, and the browser in which it is tested.
lab=(nodejs npm chromium-headless-shell)

# The site: what reads Markdown and the headers' comments, and what colours code.
site=(cmark-gfm doxygen python3 python3-pygments)

# Many machines: messages, what shares out the bodies, and MPI for Python.
mpi=(libopenmpi-dev openmpi-bin libtrilinos-zoltan-dev python3-mpi4py)

usage() {
  echo "usage: scripts/setup.sh [--list] demo|test|bench|fuzz|lint|arm|wasm|windows|abi|package|python|lab|site|mpi|npm ..." >&2
  exit 2
}

list_only=no
wanted=()
(($# > 0)) || usage
for arg in "$@"; do
  case "$arg" in
    --list) list_only=yes ;;
    demo) wanted+=("${base[@]}" "${demo[@]}") ;;
    test) wanted+=("${base[@]}" "${demo[@]}" "${test[@]}" "${threads[@]}") ;;
    bench) wanted+=("${base[@]}" "${bench[@]}" "${threads[@]}") ;;
    fuzz) wanted+=("${base[@]}" "${demo[@]}" "${fuzz[@]}") ;;
    # clang-tidy has to find every header.
    lint) wanted+=("${base[@]}" "${demo[@]}" "${test[@]}" "${threads[@]}" "${lint[@]}") ;;
    arm) wanted+=("${base[@]}" "${arm[@]}") ;;
    npm) wanted+=("${base[@]}" "${npm[@]}") ;;
    wasm) wanted+=("${base[@]}" "${wasm[@]}") ;;
    windows) wanted+=("${base[@]}" "${windows[@]}") ;;
    abi) wanted+=("${base[@]}" "${abi[@]}") ;;
    package) wanted+=("${base[@]}" "${demo[@]}" "${threads[@]}" "${package[@]}") ;;
    mpi) wanted+=("${base[@]}" "${demo[@]}" "${test[@]}" "${threads[@]}" "${mpi[@]}") ;;
    python) wanted+=("${base[@]}" "${demo[@]}" "${python[@]}") ;;
    lab) wanted+=("${lab[@]}") ;;
    site) wanted+=("${site[@]}") ;;
    *) usage ;;
  esac
done
((${#wanted[@]} > 0)) || usage

if [[ $list_only == yes ]]; then
  printf '%s\n' "${wanted[@]}" | sort -u
  exit 0
fi

[[ -n ${GRAZE_NO_SETUP:-} ]] && exit 0

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  cat >&2 <<MESSAGE
scripts/setup.sh: this is not a Debian-like system, so nothing was installed.
Install the equivalents of these packages yourself and run again with GRAZE_NO_SETUP=1:
  $(printf '%s\n' "${wanted[@]}" | sort -u | tr '\n' ' ')
MESSAGE
  exit 1
fi

# One query for all of them; a package that dpkg has never heard of is reported on stderr and is simply absent here.
# Keys are plain names: a multi-arch package is listed as `name` by ${Package}.
declare -A present=()
while read -r package status; do
  [[ $status == installed ]] && present[$package]=1
done < <(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)

# Other builds of Node.js bring npm themselves and refuse Debian's beside them.
command -v npm >/dev/null && present[npm]=1

missing=()
for package in "${wanted[@]}"; do
  [[ -n ${present[$package]:-} ]] || { missing+=("$package"); present[$package]=1; } # marked, so named only once
done
((${#missing[@]} == 0)) && exit 0

echo "scripts/setup.sh: '$*' needs ${#missing[@]} Debian package(s) that are not installed:"
echo "  ${missing[*]}"
echo "They come from the distribution with apt-get and are used only to build, test or measure Graze."

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    cat >&2 <<MESSAGE
scripts/setup.sh: installing needs root, and you are neither root nor is there a 'sudo' here. Ask an administrator for
  apt-get install --no-install-recommends ${missing[*]}
MESSAGE
    exit 1
  fi
  echo "You are not root: sudo is used, and may ask for your password."
  as_root=(sudo)
fi

# `env` after sudo, because sudo drops the environment of its caller.
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@"; }

# The package lists are fetched only where the installation would not work without: on a bare machine they are not
# there at all, on an old one they name versions that the mirror no longer has.
install() { apt install --yes --quiet --no-install-recommends "${missing[@]}"; }

simulate() { apt-get install --simulate --no-install-recommends "${missing[@]}" >/dev/null 2>&1; }
if ! simulate; then
  echo "The package lists are missing or too old: apt-get update"
  apt update --quiet
fi
if ! install; then
  echo "The installation failed; once more with fresh package lists: apt-get update"
  apt update --quiet
  install
fi
