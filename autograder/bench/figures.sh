#!/bin/sh
# The judge's figures, measured on this machine (those of the labs are ./lab bench's). Takes a few
# minutes; leave the machine alone meanwhile.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd -P)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
now() { date +%s.%N; }
median() { sort -n | sed -n "$((($1 + 1) / 2))p"; }

echo "From a fresh clone to the first verdict (packages installed)"
for i in 1 2 3; do
  git clone -q "$root" "$work/clone-$i"
  start=$(now)
  (cd "$work/clone-$i" && ./lab check variance solutions >/dev/null)
  echo "$(now) $start" | awk '{ print $1 - $2 }'
  [ "$i" = 3 ] || rm -rf "$work/clone-$i"
done | median 3 | sed 's/$/ s (median of 3)/; s/^/  /'
lab=$work/clone-3/lab
build=$work/clone-3/build

echo "From saving to a verdict (lab 1, the solution with a line added each time)"
mkdir "$work/student"
for i in 1 2 3 4 5; do
  { cat "$root/solutions/variance.cpp"; echo "// $i"; } >"$work/student/variance.cpp"
  start=$(now)
  "$lab" check variance "$work/student" >/dev/null
  echo "$(now) $start" | awk '{ print $1 - $2 }'
done | median 5 | sed 's/$/ s (median of 5)/; s/^/  /'

echo "Memory of the largest compiler process"
cmake -S "$work/clone-3" -B "$work/memory" -D CMAKE_CXX_COMPILER_LAUNCHER="/usr/bin/time;-a;-o;$work/memory.txt;-f;%M %C" >/dev/null
cmake --build "$work/memory" --target all grader_tests self_test >/dev/null
sort -n "$work/memory.txt" | tail -n 1 | awk '{ printf "  %d MB: %s\n", $1 / 1024, $NF }'

echo "The jail"
cmake --build "$build" --target bench_measurement >/dev/null
"$build/bin/bench_measurement" "$(ls "$build"/programs/variance-*/*.program | head -n 1)"
