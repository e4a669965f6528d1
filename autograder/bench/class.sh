#!/bin/sh
# Writes a class of N submissions to all labs, to measure what grading costs: the repository's own
# submissions in turn, each with its own line, so that nothing is cached. One lab in ten is
# hostile, one in ten the starter.
#
# A catalog of attacks is not one submission, so those are left out.
#
# usage: class.sh N DIR
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd -P)
count=$1 out=$2
mkdir "$out"

# What students hand in has no solution to include: its text takes the include's place.
pasted() {
  awk -v root="$root" '
    /^#include "solutions\// { split($0, part, "\""); file = root "/" part[2]
      while ((getline line < file) > 0) print line
      close(file); next }
    { print }' "$1"
}

# nth K FILE...
nth() {
  shift $((1 + $1 % ($# - 1)))
  printf %s "$1"
}

for file in "$root"/solutions/*.cpp; do
  name=${file##*/} lab=${file##*/} i=0
  lab=${lab%.cpp}
  while [ $i -lt "$count" ]; do
    i=$((i + 1))
    case $((i % 10)) in
    0) from=$(nth $((i / 10)) "$root/autograder/submissions/attacks/$lab"/[a-z]*.cpp) ;;
    5) from=$root/starter/$name ;;
    *) from=$(nth "$i" "$file" "$root/autograder/submissions/alternatives/$lab"/*.cpp) ;;
    esac
    student=$(printf 'student %04d' $i)
    mkdir -p "$out/$student"
    { pasted "$from"; echo "// $student"; } >"$out/$student/$name"
  done
done
