#!/bin/sh
# The project by clang: it builds the unit tests under the sanitizers, and they pass. Exit status: that of the first
# step that fails; 77 (skipped) where clang, its runtime or its OpenMP is
# not installed.
# Usage: clang.sh SOURCE_TREE DIRECTORY
set -eu
if ! echo 'int main() {}' | clang++ -fopenmp -fsanitize=address,undefined -x c++ - -o /dev/null 2>/dev/null; then
  echo "skipped: clang, its runtime or its OpenMP (libomp-dev) is not installed"
  exit 77
fi
cmake -S "$1" --preset sanitized -B "$2" -DCMAKE_CXX_COMPILER=clang++
ninja -C "$2" -j "$(nproc)" unit_tests
ctest --test-dir "$2" -j "$(nproc)" -L '^unit$' --output-on-failure --no-tests=error
