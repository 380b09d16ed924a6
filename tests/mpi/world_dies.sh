#!/usr/bin/env bash
# A rank of a world that is killed in the midst of its updates: all others end within seconds, and it is said why.
#
#   world_dies.sh WORLD_FAULTS_TEST
set -u
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$program" "$work/world" # a name of its own, by which its ranks are found
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fail() { echo "FAILED: $*" >&2; cat "$work/log" >&2; exit 1; }
workers() { for p in $(pgrep -f -- "$work/world forever"); do [[ $(readlink "/proc/$p/exe") == "$work/world" ]] && echo "$p"; done | sort -n; }

for which in 1 4; do
  : >"$work/log" # now, not when the shell in the background comes to it: the last round's log says "running", too
  timeout -k 5 60 mpirun --oversubscribe -n 4 "$work/world" forever >"$work/log" 2>&1 &
  started=$!
  for ((i = 0; i < 400; ++i)); do grep -q running "$work/log" && break; sleep 0.05; done
  grep -q running "$work/log" || fail "no updates after twenty seconds"
  kill -9 "$(workers | sed -n ${which}p)"
  for ((i = 0; i < 200; ++i)); do [[ -z $(workers) ]] && break; sleep 0.05; done
  [[ -z $(workers) ]] || fail "ranks go on ten seconds after one was killed"
  wait $started && fail "as if nothing had happened"
  grep -q "signal 9" "$work/log" || fail "nothing is said of it"
done
echo "passed"
