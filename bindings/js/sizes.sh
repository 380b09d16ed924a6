#!/usr/bin/env bash
# Prints the modules' sizes, plain and with gzip.
#   bindings/js/sizes.sh DIRECTORY
set -euo pipefail
cd "$1"

for module in *.wasm; do
  echo "$module: $(stat -c %s "$module") bytes, $(gzip -9 -c "$module" | wc -c) with gzip"
done
