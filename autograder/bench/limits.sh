#!/usr/bin/env bash
# Measures the judge's numbers on this machine next to the promised ones (./lab bench measures those
# of the labs). Takes about 15 minutes; leave the machine idle meanwhile. The packages must be
# installed (./lab setup).
set -euo pipefail
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd -P)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CI=true
median() { sort -n | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }
row() { printf '%-58s %10s   %s\n' "$1" "$2" "$3"; }
# wall_and_cpu COMMAND...: seconds of both, on one line
wall_and_cpu() {
  local TIMEFORMAT='%R %U %S'
  { time "$@" >/dev/null 2>&1; } 2>&1 | awk '{ print $1, $2 + $3 }'
}

row "quantity" "measured" "promised"
printf '#include <catch2/catch%s.hpp>\nTEST_CASE("a") { CHECK(1 == 1); }\n' \
  "$([ -e /usr/include/catch2/catch.hpp ] || echo _test_macros)" >"$work/one.cpp"
one=$(for _ in 1 2 3 4 5; do wall_and_cpu c++ -std=c++20 -O1 -c "$work/one.cpp" -o "$work/one.o"; done |
  cut -d' ' -f2 | median)
for i in 1 2 3; do
  git clone -q "$root" "$work/clone-$i"
  (cd "$work/clone-$i" && wall_and_cpu ./lab check variance solutions)
  [ "$i" = 3 ] || rm -rf "$work/clone-$i"
done >"$work/first.txt"
row "fresh clone to first verdict, wall" "$(cut -d' ' -f1 "$work/first.txt" | median) s" "<= 25 s"
row "the same, CPU time over that of one Catch2 test case" \
  "$(cut -d' ' -f2 "$work/first.txt" | median | awk -v one="$one" '{ printf "%.1f", $1 / one }')" "<= 30"
lab=$work/clone-3/lab
build=$work/clone-3/build

mkdir "$work/student"
"$lab" check variance solutions --only 1.1 >/dev/null 2>&1
# The verdict is printed before anything is timed.
verdict_seconds() {
  local TIMEFORMAT=%R
  { time grep -q 'of 100 points' < <("$lab" check variance "$work/student" 2>/dev/null); } 2>&1
  wait $! || true
}
for i in 1 2 3 4 5; do
  { cat "$root/solutions/variance.cpp"; echo "// $i"; } >"$work/student/variance.cpp"
  verdict_seconds
  { cat "$root/solutions/variance.cpp"; echo "// $i again"; } >"$work/student/variance.cpp"
  wall_and_cpu "$lab" check variance "$work/student" >>"$work/save.txt"
done | median >"$work/verdict.txt"
row "save to verdict, lab 1, median of 5" "$(cat "$work/verdict.txt") s" "<= 1.5 s"
row "the same, and its speed" "$(cut -d' ' -f1 "$work/save.txt" | median) s" ""

rm -rf "$work/clone-3/build"
row "grade solutions in a fresh clone, plots included" \
  "$(cd "$work/clone-3" && wall_and_cpu ./lab grade solutions | cut -d' ' -f1) s" "<= 100 s"
for folder in "$root"/labs/[0-9]*-*; do
  name=$(basename "$folder")
  row "plot $name" "$(cd "$work/clone-3" && wall_and_cpu ./lab plot "$name" | cut -d' ' -f1) s" "<= 5 s"
done
mkdir "$work/all"
for file in "$root"/solutions/*.cpp; do { cat "$file"; echo "// again"; } >"$work/all/$(basename "$file")"; done
row "all six labs of one submission" \
  "$("$lab" setup >/dev/null 2>&1; wall_and_cpu "$lab" grade "$work/all" --no-plots | cut -d' ' -f1) s" "<= 8 s"

cmake -S "$work/clone-3" -B "$work/memory" -D MC_UNITY=ON \
  -D CMAKE_CXX_COMPILER_LAUNCHER="$root/autograder/bench/peak.sh;$work/memory.txt" >/dev/null
cmake --build "$work/memory" --target all grader_tests self_test >/dev/null 2>&1
row "memory of the largest compiler process" \
  "$(sort -n "$work/memory.txt" | tail -n 1 | awk '{ printf "%d MB", $1 / 1024 }')" "<= 500 MB"
cmake --build "$build" --target bench_measurement >/dev/null
program=$(ls "$build"/programs/variance-*/*.program | head -n 1)
row "one measurement, median" \
  "$("$build/bin/bench_measurement" "$program" | sed 's/.*median \([0-9.]*\) ms.*/\1 ms/')" "<= 4 ms"
# Built before: ./lab test builds for a minute and a half where nothing is.
test_seconds() {
  (cd "$work/clone-3" && wall_and_cpu ./lab test "$@" | cut -d' ' -f1)
}
cmake --build "$build" --target tests >/dev/null
row "lab test --quick" "$(test_seconds --quick) s" "<= 60 s"
row "lab test" "$(test_seconds) s" "<= 360 s"
