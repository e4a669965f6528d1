#!/bin/sh
# Writes again what documents show of real runs: the failure in README.md, the pictures of the labs,
# the tables of handouts. (Numbers in a handout's text are written by hand; ./lab test compares them
# with what commands print.)
# (docs/speed-against-error.md is written by ./lab bench --page, on an idle machine.) Run from
# anywhere; look at what changed with git diff.
set -eu
cd "$(dirname "$0")/.."
build=${MC_BUILD:-build}

for folder in labs/[0-9]*-*; do
  lab=$(printf %s "${folder#*-}" | tr - _)
  ./lab plot "$lab" solutions >/dev/null
  for picture in "$build"/plots/side-by-side/"$lab"-*.[sp][vn]g; do
    name=${picture##*/}
    target=$folder/pictures/${name#"$lab"-}
    if [ -f "$target" ]; then cp "$picture" "$target"; fi  # only those that a handout shows
  done
done

# Drawings that show no submission's output.
mkdir -p "$build/drawings"
awk -v points="$build/drawings/relaxed.tsv" -v power="$build/drawings/relaxed-power.tsv" \
  -f docs/drawings/relaxed.awk
gnuplot -e "draw = 'labs/common/draw.gp'; place = '$build/drawings'; data = place" \
  docs/drawings/drawings.gp
for picture in "$build"/drawings/*.svg; do
  name=${picture##*/}
  cp "$picture" labs/"${name%%-*}"-*/pictures/"${name#*-}"
done

# Lab 6 shows two pictures more, which ./lab render draws.
for picture in motion stripes; do
  ./lab render "$picture" solutions >/dev/null
  cp "$build/render/$picture-samples.png" "labs/6-sampler/pictures/$picture.png"
done

# Text in pictures: no single gray has a contrast of 4.5:1 on white and on dark pages.
for picture in labs/*/pictures/*.svg; do
  grep -q '<style>' "$picture" || sed -i '0,/<title>/s//<style>text { fill: #656d76 } @media (prefers-color-scheme: dark) { text { fill: #9198a1 } }<\/style>\n<title>/' "$picture"
done

# One failure as a student sees it: Welford with the old mean in both factors.
cmake --build "$build" --target self_test >/dev/null
"$build/bin/self_test" autograder/submissions/mistakes/variance/1.4.cpp welford_old_mean |
  awk '/✗/ { if (seen++) exit } seen && /✓/ { exit } seen' |
  sed 's|mistakes/variance/welford_old_mean *||; s| --dir$||' >"$build/failure.txt"

# between FILE MARKER TEXT: writes a file's text behind the marker, a comment, up to <!-- end -->.
between() {
  awk -v marker="$2" -v from="$3" '
    /<!-- end -->/ { skip = 0 }
    !skip { print }
    index($0, marker) == 1 { seen = 1 }
    seen && /-->/ { while ((getline line < from) > 0) print line; seen = 0; skip = 1 }
  ' "$1" >"$build/refreshed.md"
  cp "$build/refreshed.md" "$1"
}
{ echo '```'; cat "$build/failure.txt"; echo '```'; } >"$build/fenced.txt"
between README.md '<!-- output: failure -->' "$build/fenced.txt"

# tables BEGINNING COMMAND...: those that the command prints whose titles begin so. (Times depend on
# the machine: the bench's page has those.)
tables() {
  beginning=$1
  shift
  "$@" --rounds 1 | awk -v RS= -v ORS='\n\n' -v beginning="$beginning" '
    index($0, beginning) == 1 { rest = 2; $0 = $0 ":" } rest-- > 0' >"$build/tables.txt"
}
definitions=autograder/submissions/alternatives/stratification/plain_definitions.cpp
tables 'kurtosis of the error of exp' ./lab bench stratification "$definitions" --tables
between docs/answers/3-stratification.md '<!-- output of ./lab bench stratification' "$build/tables.txt"
for title in 'RMSE of' 'RMSE in' 'empty cells' 'first 256' 'mean squared error'; do
  tables "$title" ./lab bench sampler --tables
  between docs/sampler-blocks.md "<!-- output of ./lab bench sampler --tables: $title" "$build/tables.txt"
done
