#!/usr/bin/env bash
# Runs all benchmarks and writes what they found as one page, with the chart of the headline.
#
#   bench/results.sh [--quick] [--poses FILE.csv] [--programs DIRECTORY] [--resume]
#
# A whole run takes seven to nine minutes on a quiet machine and writes bench/RESULTS.md, docs/benchmark.svg and the
# figures in README.md; a quick one takes two minutes, is less exact and writes below build/bench/results only. With
# --resume what an interrupted run has measured is kept.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

quick=no
poses=
programs=build/release/bin
resume=no
while (($# > 0)); do
  case "$1" in
    --quick) quick=yes ;;
    --resume) resume=yes ;;
    --poses) poses=${2:?--poses takes a file} && shift ;;
    --programs) programs=${2:?--programs takes a directory} && shift ;;
    *)
      echo "usage: bench/results.sh [--quick] [--poses FILE.csv] [--programs DIRECTORY] [--resume]" >&2
      exit 2
      ;;
  esac
  shift
done

tree=$(git describe --always --dirty --exclude '*' 2>/dev/null || echo "unknown")
load() { cut -d' ' -f1 /proc/loadavg 2>/dev/null || echo "?"; }
load_before=$(load)
work=build/bench/results/$([[ $quick == yes ]] && echo quick || echo whole)
mkdir -p "$work"
if [[ $quick == yes ]]; then
  page=$work/RESULTS.md
  chart=$work/benchmark.svg
  headline=(--pairs 10000 --seconds 0.03)
  pile=(--frames 5)
  world=(--bodies 100000 --frames 5)
  broad=(--frames 5 --largest 10000)
  uneven=(--frames 5 --largest 1000)
  rays=(--rays 20000)
  single_rays=(--rays 20000 --rounds 5)
  casts=(--pairs 500 --largest 10000)
  typed=(--pairs 2000 --rounds 9)
  compact=(--pairs 4000 --rounds 9)
  plane=(--pairs 10000 --rounds 3 --scale 0.2 --steps 100)
  compare=(--quick)
else
  page=bench/RESULTS.md
  chart=docs/benchmark.svg
  headline=()
  pile=()
  world=()
  broad=(--frames 9 --largest 100000)
  uneven=(--frames 9 --largest 10000)
  rays=()
  single_rays=()
  casts=()
  typed=()
  compact=()
  plane=(--scale 0.5 --steps 120)
  compare=()
fi
[[ -z $poses ]] || pile+=(--poses "$poses")

steps=13
step=0
# run NAME PROGRAM OPTIONS...: its output to $work/NAME.md
run() {
  local name=$1 program=$2
  shift 2
  step=$((step + 1))
  [[ $resume == no || ! -f $work/$name.md ]] || return 0
  printf '[%d/%d, %3d s] %s\n' "$step" "$steps" "$SECONDS" "$name" >&2
  "$programs/bench_$program" "$@" >"$work/$name.part"
  mv "$work/$name.part" "$work/$name.md"
}

[[ $resume == yes ]] || rm -f "$work"/*.md
run headline headline "${headline[@]}" --chart "$chart" --short "$work/short.md" --memory "$work/memory.md"
run pile pile "${pile[@]}"
run world world "${world[@]}"
run broad broad "${broad[@]}" --scene 'coherent|tenth|teleport|spread|clustered'
run uneven broad "${uneven[@]}" --scene uneven
run rays rays "${rays[@]}"
run ray_shapes ray_shapes "${single_rays[@]}"
run casts casts "${casts[@]}"
run typed_query typed_query "${typed[@]}"
run compact_contacts compact_contacts "${compact[@]}"
run plane plane "${plane[@]}"
run compare compare "${compare[@]}" --brief
run example example --pairs 1000 --repetitions 3 --only 'box-box overlap' --libraries 'bounds|graze'

system=$(. /etc/os-release 2>/dev/null && echo "$PRETTY_NAME" || uname -s)
memory=$(awk '/^MemTotal/ { printf "%.0f GiB", $2 / 1048576 }' /proc/meminfo 2>/dev/null || echo "?")
effort=$([[ $quick == yes ]] && echo "a quick run, less exact," || echo "a whole run")

{
  cat <<TEXT
# Benchmarks

Written by \`make bench\`: $effort of Graze $tree on $system, $memory of memory, load $load_before when it began
(that of others, best 0) and $(load) when it ended (best 1).

All libraries are asked the same in one process, one after the other in every repetition; times are medians. Graze is
compiled as for its users, with the compiler's defaults for the processor: wider instructions are chosen at start. The
other libraries are the distribution's packages. The first lines of \`bench/<name>.cpp\` say how each table is made;
[peer.hpp](peer.hpp) says how to add a library: one file.

## The pairs that programs ask about most

TEXT
  cat "$work/headline.md"
  printf '\n## Memory\n\n'
  cat "$work/memory.md"
  printf 'Of worlds and broad phases see the columns `B/body` and `B/box` below.\n'
  printf '\n## A settled pile, every body awake\n\n'
  if [[ -n $poses ]]; then
    printf 'The poses are those of a file, %s: a pile that a simulation left.\n' "$(basename "$poses")"
  else
    printf 'Boxes in a pyramid, each on four, a little turned, a little sunk in.\n'
  fi
  cat <<'TEXT'
A frame moves every body to and fro by 1e-4 of its size, and then the whole update is asked for, on one thread.
`pairs` are what the broad phase passes on; contacts are points, with Graze and Bullet those up to 0.02 apart, with ODE
only those of boxes that overlap. `still`: nothing changed since the last frame. What a second thread saves is measured
apart, by the clock, in turns with one thread. `2, awake`: an empty task wakes the second thread before the poses are
given; else it has slept since the last update. `2 worlds`: two such worlds updated at once, a thread each, which share
nothing: what the processors had for a second thread at that time.

TEXT
  cat "$work/pile.md"
  printf '\n## A large world, everything moving\n\nHalf boxes, half spheres, 0.5 to 1.5 wide, in heaps at random; by 1 and 2 threads.\n\n'
  cat "$work/world.md"
  cat <<'TEXT'

## Broad phases

Boxes alone, one thread: the update and all pairs, every frame. All boxes drift, every tenth does, all jump anywhere,
one in a hundred is 50 times larger and all have four neighbours still (`spread`), or they stand in a few heaps; last
(`uneven`), the large ones stand among as many others as fit in, and overlap most. Those that keep fat boxes find more
pairs than there are; `moved` asks only for the pairs of what moved. [Which to take](../docs/broad-phases.md).

TEXT
  cat "$work/broad.md"
  grep '^| uneven' "$work/uneven.md"
  printf '\n## Rays at a mesh\n\n'
  cat "$work/rays.md"
  cat <<'TEXT'

`ratio` and `differ` are against Embree's robust mode: what its rate is of that one's, and how many first hits are
elsewhere. Graze is watertight as that one is, and computes in double.

## Rays at single shapes

Rays that come from all sides at one turned shape: nanoseconds a ray, one at a time and all of them in a batch.

TEXT
  cat "$work/ray_shapes.md"
  cat <<'TEXT'

## Casts

Pairs that move along a line, at 0.1 % and 1 % of their size how many answers are wrong; and rays and casts in worlds of
boxes, one thread.

TEXT
  cat "$work/casts.md"
  cat <<'TEXT'

## Pairs whose kinds the caller knows

One pair at a time, in turns: as two `Shape`s (`graze/query.hpp`), and by callers who know their kinds
(`graze/typed_query.hpp`), who get the same bits. Contacts up to 0.02 apart.

TEXT
  cat "$work/typed_query.md"
  cat <<'TEXT'

## Contacts of a batch, whole and compact

Pairs in arrays of one kind, in turns: whole contacts (`graze/batch_contacts.hpp`), and normals, places and distances
only (`graze/compact_contacts.hpp`), with the same bits. Contacts up to 0.02 apart; `bytes`: of the answer, a pair.

TEXT
  cat "$work/compact_contacts.md"
  cat <<'TEXT'

## The plane

Pairs of shapes in two dimensions beside Box2D, in float, on one thread: nanoseconds for one question, with few pairs in
the cache one at a time and with many from memory in a batch; last scenes that are played. `faster`: how many times as
fast as Box2D. [What was aimed at, and what holds back the rows that miss it](../docs/plane.md#speed-and-where-it-ends-so-far).

```
TEXT
  cat "$work/plane.md"
  printf '```\n'
  printf '\n## Every pair of shapes\n\nAll 44 pairs of nine shapes by `bench_compare`, which prints each of them.\n\n'
  cat "$work/compare.md"
} >"$work/page.md"
mv "$work/page.md" "$page"

grep -q '^| box-box overlap *| bounds ' "$work/example.md" || {
  echo "bench/results.sh: bench_example does not show the library that it adds" >&2
  exit 1
}

# Between the two marks in README.md stand the figures of the last whole run.
if [[ $quick == no ]]; then
  {
    awk '/<!-- measured -->/ { print; exit } { print }' README.md
    printf '%s, one thread of an %s:\n' "$(sed -n 's/^- date: //p' "$work/headline.md")" \
      "$(sed -n 's/^- processor: \([^,]*\).*/\1/p' "$work/headline.md")"
    cat "$work/short.md"
    awk '/<!-- \/measured -->/ { found = 1 } found { print }' README.md
  } >"$work/README.md"
  mv "$work/README.md" README.md
fi
echo "$page and $chart were written in $SECONDS s" >&2
