#!/usr/bin/env bash
# Gradescope, building its image (Ubuntu 22.04): this repository lies in /autograder/source.
set -euo pipefail
cd /autograder/source
CI=true ./lab setup
