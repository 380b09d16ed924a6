#!/usr/bin/env bash
# Tests of graze-mpi collide against graze collide: the same contacts, of scenes in one file and in parts; faults.
#
#   collide.sh GRAZE GRAZE_MPI OTHER SOURCE CASE     OTHER: graze-mpi of another version; SOURCE: the tree
set -u
graze=$1 graze_mpi=$2 other=$3 source=$4 case=$5
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
command -v python3 >/dev/null || { echo "SKIPPED: scenes are written by Python, which is not here"; exit 77; }
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

fail() { echo "FAILED: $*" >&2; [[ -e log ]] && cat log >&2; exit 1; }
ranks() { timeout -k 5 60 mpirun --oversubscribe -n "$@"; }
expect() { # CODE COMMAND...: that it ends with that code
  local code=$1; shift
  "$@" >log 2>&1; local got=$?
  [[ $got == "$code" ]] || fail "exit code $got and not $code: $*"
}
said() { grep -qF -- "$1" log || fail "nothing said of: $1"; }
town() { python3 "$source/examples/make_tiled_scene.py" "$@" || fail "no scene was written"; }
# The pairs of graze collide --json, one a line, beside those of --contacts.
same() { # FILES... -- OPTIONS...
  python3 - contacts.jsonl <(eval "$graze collide $* --json") <<'PYTHON' || fail "other contacts than those of graze collide: $*"
import json, sys
got = [json.loads(line) for line in open(sys.argv[1])]
want = json.load(open(sys.argv[2]))["pairs"]
assert len(want) >= 10 and got == want, (len(got), len(want))
PYTHON
}

case $case in
  same)
    town town.gltf --tiles 3 2 --bodies 24
    demo=$source/examples/scenes/demo.gltf
    for run in "1:$demo" "3:$demo town.gltf" "4:town.gltf --margin 0.05 --precision float" "2:town.gltf --points 4"; do
      expect 0 ranks "${run%%:*}" "$graze_mpi" collide ${run#*:} --contacts contacts.jsonl --svg owners.svg
      said "in contact"; said "balance (largest over mean)"
      same ${run#*:}
      python3 -c 'import sys, xml.dom.minidom as x; n = len(x.parse("owners.svg").getElementsByTagName("polygon")); sys.exit(n < 20)' || fail "no picture"
    done
    ;;
  faults)
    town town.gltf --tiles 3 2 --bodies 6
    expect 2 ranks 3 "$graze_mpi" collide nothing.gltf; said "nothing.gltf"
    rm town/1-0.gltf
    expect 2 ranks 3 "$graze_mpi" collide town.gltf; said "1-0.gltf"
    cp town.gltf town/1-0.gltf
    expect 2 ranks 3 "$graze_mpi" collide town.gltf; said "a tile, which references no tiles"
    sed 's|town/0-0.gltf|../town/0-0.gltf|' town.gltf >out.gltf
    expect 2 ranks 2 "$graze_mpi" collide out.gltf; said "out.gltf: nodes[0].extras.grazeTile: expected a file below"
    town town.gltf --tiles 3 2 --bodies 6
    expect 2 ranks 1 "$graze_mpi" collide town.gltf : -n 2 "$other" collide town.gltf; said "expected what rank 0 has"
    expect 2 ranks 1 "$graze_mpi" collide town.gltf : -n 1 "$graze_mpi" collide town.gltf --precision float; said "float"
    expect 2 ranks 2 "$graze_mpi" collide town.gltf --svg a.svg : -n 1 "$graze_mpi" collide town.gltf
    said "the files to write"
    expect 2 ranks 2 "$graze_mpi" collide town.gltf --svg nowhere/a.svg; said "nowhere/a.svg"
    expect 2 ranks 2 "$graze_mpi" collide town.gltf --margin -1; said "--margin"
    expect 2 ranks 2 "$graze_mpi" collide town.gltf --margin ""; said "--margin: expected a number, got nothing"
    echo '{"asset": {"version": "2.0"}}' >nothing.gltf # no body on any rank
    expect 0 ranks 2 "$graze_mpi" collide nothing.gltf; said "0 pairs in contact"
    ln -s /dev/full full.jsonl
    expect 2 ranks 2 "$graze_mpi" collide town.gltf --contacts full.jsonl; said "full.jsonl"; said "no space left"
    # No byte beyond so many, as on a full disk: the file is as it was. By TCP, because shared memory is a file too.
    town town.gltf --tiles 3 2 --bodies 24
    for option in "--contacts kept.jsonl" "--svg kept.svg"; do
      file=${option#* }
      echo old >$file
      expect 2 ranks 2 --mca btl self,tcp bash -c 'ulimit -f 16; exec "$0" "$@"' "$graze_mpi" collide town.gltf $option
      said "$file: cannot be written: file too large"
      [[ $(cat $file) == old && ! -e $file.partial ]] || fail "half of $file"
    done
    expect 2 ranks 2 sh -c '[ "$OMPI_COMM_WORLD_RANK" = 0 ] && exec >/dev/full; exec "$0" "$@"' "$graze_mpi" collide town.gltf
    said "standard output cannot be written"
    expect 0 ranks 2 "$graze_mpi" collide --help; said "Example:"
    for question in --help "collide --help" "query --help" --version; do
      expect 2 ranks 2 sh -c 'exec "$0" "$@" >/dev/full' "$graze_mpi" $question
      said "standard output cannot be written: No space left on device"
    done
    ;;
  *) fail "no such case" ;;
esac
echo "passed: $case"
