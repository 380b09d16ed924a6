#!/usr/bin/env bash
# Writes the derived parts of the C header: the version from CMakeLists.txt, and the part for float from the part for
# double, without its comments. With --check it only reports whether the header is as it would be written.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
header=include/graze/graze.h

version=$(sed -n 's/^ *VERSION \([0-9]*\.[0-9]*\.[0-9]*\)$/\1/p' CMakeLists.txt | head -1)
IFS=. read -r major minor patch <<<"$version"

float_part() {
  sed -n '/^\/\/ <double>$/,/^\/\/ <\/double>$/p' "$header" |
    sed -E -e '/^ *\/\//d' -e 's, *//.*$,,' -e 's/\b(Graze[A-Za-z0-9]+)d\b/\1f/g' \
      -e 's/\b(Graze[A-Za-z]+(I|Kin))f\b/\1d/g' -e 's/\b(graze_[a-z_0-9]+)_d\b/\1_f/g' -e 's/\bdouble\b/float/g' |
    cat -s
}

written() {
  sed -E -e "s/^(#define GRAZE_VERSION_MAJOR) .*/\1 $major/" -e "s/^(#define GRAZE_VERSION_MINOR) .*/\1 $minor/" \
    -e "s/^(#define GRAZE_VERSION_PATCH) .*/\1 $patch/" -e "s/^(#define GRAZE_VERSION_STRING) .*/\1 \"$version\"/" \
    -e '/^\/\/ <float>$/q' "$header"
  float_part
  sed -n '/^\/\/ <\/float>$/,$p' "$header"
}

if [[ ${1:-} == --check ]]; then
  diff -u "$header" <(written) || { echo "$header is stale: run bindings/c/write_float.sh" >&2; exit 1; }
else
  text=$(written)
  printf '%s\n' "$text" >"$header"
fi
