#!/bin/sh
# Launches a compiler for limits.sh: peak.sh FILE COMMAND...; adds its peak memory in KB to FILE.
file=$1
shift
exec python3 -c '
import resource, subprocess, sys
status = subprocess.call(sys.argv[2:])
with open(sys.argv[1], "a") as file:
    print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, file=file)
sys.exit(status)' "$file" "$@"
