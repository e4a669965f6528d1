#!/bin/sh
# Writes again what documents show of real runs: the failure in README.md, the pictures of the labs,
# the tables of lab 6's handout.
# (docs/speed-against-error.md is written by ./lab bench --page, on an idle machine.) Run from anywhere;
# look at what changed with git diff.
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

# Lab 6 shows two pictures more, which ./lab render draws.
for picture in motion stripes; do
  ./lab render "$picture" solutions >/dev/null
  cp "$build/render/$picture-samples.png" "labs/6-sampler/pictures/$picture.png"
done

# One failure as a student sees it: Welford with the old mean in both factors.
cmake --build "$build" --target self_test >/dev/null
"$build/bin/self_test" autograder/submissions/mistakes/variance/welford_old_mean.cpp |
  awk '/✗/ { if (seen++) exit } seen && /✓/ { exit } seen' |
  sed 's|autograder/submissions/mistakes/variance/welford_old_mean.cpp *||; s| --dir$||' >"$build/failure.txt"

# between FILE NAME TEXT: writes a file's text between the markers <!-- output: NAME --> and <!-- end -->
# of a document.
between() {
  awk -v marker="<!-- output: $2 -->" -v from="$3" '
    $0 == marker { print; while ((getline line < from) > 0) print line; skip = 1 }
    /<!-- end -->/ { skip = 0 }
    !skip { print }
  ' "$1" >"$build/refreshed.md"
  cp "$build/refreshed.md" "$1"
}
{ echo '```'; cat "$build/failure.txt"; echo '```'; } >"$build/fenced.txt"
between README.md failure "$build/fenced.txt"

# The tables of lab 6's handout: what each next2() is worth. (Times hang on the machine: the bench's
# page has those.)
./lab bench sampler --tables --rounds 1 >"$build/tables.txt"
awk -v RS= -v ORS='\n\n' '/^RMSE/ { rest = 2; $0 = $0 ":" } rest-- > 0' \
  "$build/tables.txt" >"$build/next2.txt"
between labs/6-sampler/README.md next2 "$build/next2.txt"
