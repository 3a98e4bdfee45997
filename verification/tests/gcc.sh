#!/bin/sh
# The project by g++, where `./slosh test` takes clang: it builds the unit tests under the sanitizers, and they pass.
# Exit status: that of the first step that fails.
# Usage: gcc.sh SOURCE_TREE DIRECTORY
set -eu
cmake -S "$1" --preset sanitized -B "$2" -DCMAKE_CXX_COMPILER=g++
ninja -C "$2" -j "$(nproc)" unit_tests
ctest --test-dir "$2" -j "$(nproc)" -L '^unit$' --output-on-failure --no-tests=error
