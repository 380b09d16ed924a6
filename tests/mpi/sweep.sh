#!/usr/bin/env bash
# Tests of graze-mpi query against graze query: the same bytes, kill and resume, faults.
#
#   sweep.sh GRAZE GRAZE_MPI OTHER CASE     OTHER: graze-mpi of another version
#
# Ranks share the processors of this machine, however few. What must not hang has a time limit, which is an error.
set -u
graze=$1 graze_mpi=$2 other=$3 case=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

fail() { echo "FAILED: $*" >&2; [[ -e log ]] && cat log >&2; exit 1; }
ranks() { timeout -k 5 "${limit:-60}" mpirun --oversubscribe -n "$@"; }

# So many questions of every kind, with errors, blank lines, \r, no line end at the end, and lines longer than a chunk.
questions() {
  awk -v n="$1" 'BEGIN {
    for (i = 0; i < n; ++i) {
      x = i * 0.37 % 3;
      if (i % 101 == 100) { print "{\"query\": \"distance\"}"; continue }
      if (i % 101 == 50) { print "  "; continue }
      if (i % 101 == 51) { print "not json\r"; continue }
      if (i % 997 == 996) {
        printf "{\"query\": \"overlap\", \"a\": {\"shape\": {\"type\": \"convex\", \"convex\": {\"points\": [[0,0,0]";
        for (k = 0; k < 6000; ++k) printf ",[%g,%g,%g]", k % 7, k % 11, k % 13 / 3;
        printf "]}}}, \"b\": {\"shape\": {\"type\": \"sphere\"}, \"translation\": [%g,0,0]}}\n", x; continue }
      q = i % 3 == 0 ? "contacts" : i % 3 == 1 ? "distance" : "overlap";
      printf "{\"id\": %d, \"query\": \"%s\", \"a\": {\"shape\": {\"type\": \"box\"}}, \"b\": {\"shape\": {\"type\": \"capsule\"}, \"translation\": [%.17g, 0.3, %.17g]}}%s",
        i, q, x, x / 7, i + 1 < n ? "\n" : "";
    } }'
}

# One kind of question that takes so long that a run can be killed in its midst.
slow_questions() {
  awk -v n="$1" 'BEGIN {
    for (i = 0; i < n; ++i) {
      printf "{\"query\": \"distance\", \"a\": {\"shape\": {\"type\": \"convex\", \"convex\": {\"points\": [[0,0,%d]", i % 5;
      for (k = 0; k < 1500; ++k) printf ",[%.6f,%.6f,%.6f]", sin(k), cos(k * 1.3), sin(k * 0.7 + i);
      printf "]}}}, \"b\": {\"shape\": {\"type\": \"sphere\"}, \"translation\": [4,%d,0]}}\n", i % 3;
    } }'
}

expect() { # CODE COMMAND...: that it ends with that code
  local code=$1; shift
  "$@" >log 2>&1; local got=$?
  [[ $got == "$code" ]] || fail "exit code $got and not $code: $*"
}
nothing_left() { [[ $(ls -d answers* 2>/dev/null) == "${1:-}" ]] || fail "left: $(ls -d answers*)"; }
said() { grep -qF -- "$1" log || fail "nothing said of: $1"; }
same() { cmp -s expected answers || fail "other answers than those of graze query: $*"; }

# Those that belong to this test alone: its folder stands in their command line.
processes() { pgrep -f -- "query $work/" || true; }
workers() { for p in $(processes); do [[ $(readlink "/proc/$p/exe") == $(readlink -f "$graze_mpi") ]] && echo "$p"; done; }
records() { cat "$work"/answers.journal/part-* 2>/dev/null | wc -c; }
start_slow() { # RANKS: in the background, until some of it is in the journal
  mpirun --oversubscribe -n "$1" "$graze_mpi" query "$work/questions" --out "$work/answers" >log 2>&1 &
  started=$!
  for ((i = 0; i < 600; ++i)); do
    (($(records) > 0)) && return
    kill -0 $started 2>/dev/null || fail "ended before anything was in the journal"
    sleep 0.05
  done
  fail "nothing in the journal after half a minute"
}
ends_soon() {
  for ((i = 0; i < 200; ++i)); do
    [[ -z $(workers) ]] && ! kill -0 $started 2>/dev/null && { wait $started; return; }
    sleep 0.05
  done
  fail "goes on ten seconds after the kill"
}
resumes() { # RANKS: the rest, of which the journal spares some
  [[ ! -e answers ]] || fail "answers after a run that was killed"
  expect 0 ranks "$1" "$graze_mpi" query "$work/questions" --out "$work/answers" --report
  same "after a kill"
  grep -q 'of which the journal had 0' log && fail "nothing was remembered"
  nothing_left answers
}

case $case in
  same)
    questions 2000 >questions
    for precision in double float; do
      "$graze" query questions --precision $precision >expected
      for n in $([[ $precision == double ]] && echo 1 2 4 || echo 3); do
        expect 1 ranks $n "$graze_mpi" query questions --precision $precision --out answers
        same "$n ranks, --out"; nothing_left answers; rm answers
        ranks $n "$graze_mpi" query questions --precision $precision >answers 2>log; same "$n ranks, standard output"
        rm answers
      done
    done
    expect 1 ranks 3 "$graze_mpi" query questions --out answers --precision float
    expect 1 ranks 2 "$graze_mpi" query questions --out answers --precision float # over what is there
    same "written again"
    mkdir links && ln -s links/real answers.link # which stays one
    expect 1 ranks 2 "$graze_mpi" query questions --out answers.link --precision float
    [[ -L answers.link ]] && cmp -s expected links/real || fail "a link is gone, or leads to other answers"
    rm -r links answers.link
    echo kept >precious; ln -s precious answers.partial # no place for half of the answers
    expect 1 ranks 2 "$graze_mpi" query questions --out answers --precision float
    same "a link as partial file"; [[ $(cat precious) == kept && ! -L answers ]] || fail "written through a link"
    ranks 2 "$graze_mpi" query questions --journal kept --precision float >answers 2>log; same "a journal and standard output"
    [[ ! -e kept ]] || fail "the journal is left"
    : >questions; : >expected; rm answers
    expect 0 ranks 4 "$graze_mpi" query questions --out answers; same "no questions"
    ;;
  kill_one)
    slow_questions 700 >questions
    "$graze" query questions >expected
    for n in 2 4; do # of two the first, of four the last
      start_slow $n
      kill -9 "$(workers | sort -n | if ((n == 2)); then head -1; else tail -1; fi)"
      ends_soon
      said "signal 9"
      resumes 3
      rm answers
    done
    ;;
  kill_all)
    slow_questions 700 >questions
    "$graze" query questions >expected
    for n in 3; do
      start_slow $n
      kill -9 $(processes)
      ends_soon
      resumes 4
      rm answers
    done
    # A torn end: the last record of a part lacks its end, the bytes of another are not what they were.
    start_slow 2
    kill -9 $(processes); ends_soon
    part=$(ls -S answers.journal/part-* | head -1)
    truncate -s -1 "$part"
    echo xx >>"$part"
    expect 0 ranks 2 "$graze_mpi" query "$work/questions" --out "$work/answers"
    same "after a torn end"
    ;;
  other_sweep)
    slow_questions 700 >questions
    start_slow 2
    kill -9 $(processes); ends_soon
    expect 2 ranks 2 "$graze_mpi" query "$work/questions" --out "$work/answers" --precision float
    said "answers.journal: expected the journal of this sweep"
    sed -i '1s/\[0,0,0\]/[0,0,1]/' questions # as many bytes
    sed -i 's/sin/sin/; 65s/\[4,/[5,/' questions
    expect 2 ranks 2 "$graze_mpi" query "$work/questions" --out "$work/answers"
    said "expected the questions that the journal has answers to"
    [[ ! -e answers ]] || fail "answers to other questions"
    ;;
  faults)
    questions 300 >questions
    expect 2 ranks 3 "$graze_mpi" query nothing --out answers
    said "nothing: cannot be opened: No such file or directory"
    expect 2 ranks 3 "$graze_mpi" query . --out answers
    said ".: expected a regular file"
    expect 2 ranks 3 "$graze_mpi" query questions --out nowhere/answers
    said "nowhere/answers"
    expect 2 ranks 2 "$graze_mpi" query
    said "FILE is required"
    expect 2 ranks 1 "$graze_mpi" query questions : -n 2 "$other" query questions
    said "expected what rank 0 has"
    expect 2 ranks 1 "$graze_mpi" query questions : -n 1 "$graze_mpi" query questions --precision float
    said "precision float"
    expect 2 ranks 1 "$graze_mpi" query questions : -n 1 "$graze_mpi" query questions --unknown
    said "the command line: expected what rank 0 has"
    expect 2 ranks 1 "$graze_mpi" query questions : -n 1 "$graze_mpi" --help
    said "the command line: expected what rank 0 has"
    expect 2 ranks 1 "$graze_mpi" query questions --out answers : -n 1 "$graze_mpi" query questions
    said "the output and the journal: expected what rank 0 has"
    cp questions other.partial
    expect 2 ranks 2 "$graze_mpi" query other.partial --out other
    said "other.partial: expected another file than the questions"
    cmp questions other.partial || fail "the questions are other ones"
    rm other.partial
    mkdir taken && touch taken/file
    expect 2 ranks 2 "$graze_mpi" query questions --out answers --journal taken
    said "taken: expected the journal of a sweep, or nothing"
    [[ -e taken/file ]] || fail "a file of somebody else is gone"
    ln -s questions answers.link
    for name in questions ./questions answers.link; do # they would be lost
      expect 2 ranks 2 "$graze_mpi" query questions --out $name
      said "$name: expected another file than the questions"
    done
    rm answers.link; questions 300 | cmp - questions || fail "the questions are other ones"
    # A device takes no file's place: what is renamed to its name would.
    expect 2 ranks 3 "$graze_mpi" query questions --out /dev/full
    said "/dev/full: expected a regular file, or nothing"
    [[ -c /dev/full && ! -e /dev/full.partial ]] || fail "/dev/full is not what it was"
    expect 2 ranks 2 "$graze_mpi" query questions --out answers --journal /dev/full
    said "/dev/full"
    rm -f answers.partial
    nothing_left
    # Standard output goes through a shell here, since mpirun does not say when it cannot write on.
    expect 2 ranks 3 sh -c '[ "$OMPI_COMM_WORLD_RANK" = 0 ] && exec >/dev/full; exec "$0" "$@"' "$graze_mpi" query questions
    said "rank 0: answers cannot be written: No space left on device"
    expect 2 ranks 2 sh -c '[ "$OMPI_COMM_WORLD_RANK" = 0 ] && exec >/dev/full; exec "$0" "$@"' "$graze_mpi" query questions --journal kept
    said "rank 0: answers cannot be written: No space left on device"
    [[ -e kept/head ]] || fail "the journal is gone before the answers are written"
    rm -r kept
    ;;
  full_disk)
    questions 3000 >questions
    mkdir small
    mount -t tmpfs -o size=128k tmpfs small 2>/dev/null || { echo "SKIPPED: no small file system can be mounted here"; exit 77; }
    trap 'umount "$work/small"; rm -rf "$work"' EXIT
    expect 2 ranks 3 "$graze_mpi" query questions --out small/answers
    said "No space left on device"
    [[ ! -e small/answers ]] || fail "half of the answers"
    # Room for the journal, none for the answers.
    expect 2 ranks 3 "$graze_mpi" query questions --out small/answers --journal journal
    said "small/answers.partial: cannot be written"
    [[ ! -e small/answers ]] || fail "half of the answers"
    mount -o remount,size=4m small
    expect 1 ranks 2 "$graze_mpi" query questions --out small/answers --journal journal --report
    said "chunks"
    grep -q 'of which the journal had 0' log && fail "nothing was remembered"
    "$graze" query questions >expected; cp small/answers answers; same "after the disk had room again"
    ;;
  *) fail "no such case" ;;
esac
echo "passed: $case"
