#!/bin/sh
# Writes again what documents show of real runs, with the solutions:
#
#   $ ./lab run LAB …                       in a fenced block: what the command prints, below it
#   <!-- output of COMMAND -->              tables: what it prints, up to <!-- end -->
#   <!-- output of COMMAND: BEGINNING -->   only the tables whose titles begin so
#
# and the failure in README.md, the pictures of the labs and the drawings. A block of output without
# its command is refused. With --check, it writes copies of the documents, without pictures and
# without the tables of ./lab bench, which take minutes, and fails where one differs (the test
# `numbers`). docs/speed-against-error.md is written by ./lab bench --page, on an idle machine.
set -eu
case $0 in /*) self=$0 ;; *) self=$PWD/$0 ;; esac
cd "$(dirname "$0")/.."
build=${MC_BUILD:-$PWD/build}
work=$build/refreshed

# What a command prints, or its tables whose titles begin so. Each command runs once. The program is
# called directly: ./lab would look what to build each time.
if [ "${1:-}" = --output ]; then
  file=$work/$(printf %s "$2" | cksum | tr -d ' ').txt
  if ! [ -e "$file" ]; then
    words=${2#./lab }
    case $words in 'run '*) words="run --dir solutions ${words#run }" ;; esac
    eval "MC_NO_BUILD=1 '$build/bin/lab' $words" >"$file" 2>"$work/messages" || cat "$work/messages" >>"$file"
  fi
  if [ -z "${3:-}" ]; then exec cat "$file"; fi
  exec awk -v RS= -v ORS='\n\n' -v beginning="$3" \
    'index($0, beginning) == 1 { rest = 2; $0 = $0 ":" } rest-- > 0' "$file"
fi

rm -rf "$work"
mkdir -p "$work/documents"

# One failure as a student sees it: Welford with the old mean in both factors.
{
  echo '```'
  MC_UNCHANGED_TOO=1 "$build/bin/self_test" autograder/submissions/mistakes/variance/1.4.cpp welford_old_mean |
    awk '/✗/ { if (seen++) exit } seen && /✓/ { exit } seen' |
    sed 's|mistakes/variance/welford_old_mean *||; s| --dir$||'
  echo '```'
} >"$work/failure.txt"

find README.md CONTRIBUTING.md docs labs -name '*.md' ! -name speed-against-error.md |
  while read -r document; do
    copy=$work/documents/$document
    mkdir -p "$(dirname "$copy")"
    awk -v self="$self" -v check="${1:-}" -v failure="$work/failure.txt" -v document="$document" '
      function words(text) { gsub(/\047/, "\047\\\047\047", text); return "\047" text "\047" }
      function put(source,   line) {
        while ((source | getline line) > 0) print line
        close(source)
      }
      function put_output(command, beginning) {
        put(self " --output " words(command) " " words(beginning))
      }
      skip && /^<!-- end -->/ { skip = 0 }
      skip { next }
      /^<!-- output/ {
        marker = $0; print
        while (marker !~ /-->/ && (getline line) > 0) { marker = marker " " line; print line }
        sub(/^<!-- output( of|:) */, "", marker); sub(/ *-->.*/, "", marker)
        colon = index(marker, ": ")
        if (check != "" && marker ~ /^\.\/lab bench /) next
        if (marker == "failure") put("cat " words(failure))
        else if (colon == 0) put_output(marker, "")
        else put_output(substr(marker, 1, colon - 1), substr(marker, colon + 2))
        skip = 1; next
      }
      /^ *```/ { fenced = !fenced; shown = 0; print; next }
      fenced && /^\$ \.\/lab / { print; put_output(substr($0, 3), ""); shown = 1; next }
      fenced && shown { next }
      fenced && /[✓✗] |^# [a-z_]+  |of 100 points/ {
        print document ": output without its command: " $0 >"/dev/stderr"; bad = 1
      }
      { print }
      END { exit bad }' "$document" >"$copy"
  done

if [ "${1:-}" = --check ]; then
  cd "$work/documents"
  find . -name '*.md' | while read -r document; do
    git diff --no-index --exit-code "$OLDPWD/$document" "$document" || exit 1
  done
  exit
fi
cp -R "$work/documents/." .

for folder in labs/[0-9]*-*; do
  lab=$(printf %s "${folder#*-}" | tr - _)
  ./lab plot "$lab" solutions >/dev/null
  for picture in "$build"/plots/solutions/"$lab"-*.[sp][vn]g; do
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
