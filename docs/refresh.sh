#!/bin/sh
# Writes again what documents show of real runs: the output in README.md, the pictures of the labs.
# (docs/speed-against-error.md is written by ./lab bench --page, on an idle machine.) Run from anywhere; look at what changed with git diff.
set -eu
cd "$(dirname "$0")/.."
build=${MC_BUILD:-build}

# The first lab check by check, and the summary of all.
./lab grade solutions --seed 1 --no-plots >"$build/grade-all.txt"
awk '/^Lab 2/ { cut = 1; print "…\n" } /^solutions/ { cut = 0 } !cut' "$build/grade-all.txt" \
  >"$build/grade.txt"
for folder in labs/[0-9]*-*; do
  lab=$(printf %s "${folder#*-}" | tr - _)
  ./lab plot "$lab" solutions >/dev/null
  for picture in "$build"/plots/side-by-side/"$lab"-*.[sp][vn]g; do
    name=${picture##*/}
    target=$folder/pictures/${name#"$lab"-}
    if [ -f "$target" ]; then cp "$picture" "$target"; fi  # only those that a handout shows
  done
done

# Between the markers <!-- output: grade --> and <!-- end --> of README.md.
awk -v from="$build/grade.txt" '
  /<!-- output: grade -->/ { print; print "```"; while ((getline line < from) > 0) print line; print "```"; skip = 1 }
  /<!-- end -->/ { skip = 0 }
  !skip { if (!/<!-- output: grade -->/) print }
' README.md >"$build/README.new"
cp "$build/README.new" README.md
