#!/usr/bin/env bash
# Compares the binary interface that include/graze/graze.h declares (functions, parameters, members of structs and their
# offsets, enumerators) with the one recorded in bindings/c/abi.xml, by libabigail; --update records it anew, as is
# right where a new version changes it on purpose.
#
# The library is made of empty functions, one for each declaration, so that the record holds the view of C programs and
# nothing of the inside; that libgraze.so has exactly these functions is a test of its own (install.symbols).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
record=bindings/c/abi.xml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

{
  echo '#include <graze/graze.h>'
  echo 'void abort(void);'
  tr '\n' ' ' <include/graze/graze.h | grep -o 'GRAZE_C_API [^;{]*);' | sed 's/;$/ { abort(); }/'
} >"$work/empty.c"
"${CC:-gcc}" -std=c99 -g -O0 -fPIC -shared -fvisibility=hidden -Iinclude -Wl,-soname,libgraze.so "$work/empty.c" -o "$work/libgraze.so"

if [[ ${1:-} == --update ]]; then
  abidw --no-show-locs --no-corpus-path --no-comp-dir-path --no-elf-needed --out-file "$record" "$work/libgraze.so"
  # Paths of this machine would differ elsewhere.
  sed -i -E "s, path='[^']*',,; s, comp-dir-path='[^']*',," "$record"
  echo "$record: $(grep -c '<elf-symbol' "$record") functions"
elif ! abidiff --no-show-locs "$record" "$work/libgraze.so"; then
  echo "The C interface is not the one in $record. Where that is on purpose: bindings/c/abi.sh --update" >&2
  exit 1
fi
