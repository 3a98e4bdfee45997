#!/bin/sh
# The project by clang: it builds the unit tests under the sanitizers, they pass, and clang-tidy finds nothing of its
# list (.clang-tidy) in them. Exit status: that of the first step that fails; 77 (skipped) where clang, its OpenMP or
# clang-tidy is not installed.
# Usage: clang.sh SOURCE_TREE DIRECTORY
set -eu
source_tree=$1
directory=$2
for program in clang++ run-clang-tidy; do
  if ! command -v $program >/dev/null; then
    echo "skipped: $program is not installed"
    exit 77
  fi
done
if ! echo 'int main() {}' | clang++ -fopenmp -x c++ - -o /dev/null 2>/dev/null; then
  echo "skipped: clang's OpenMP (libomp-dev) is not installed"
  exit 77
fi
cmake -S "$source_tree" --preset sanitized -B "$directory" -DCMAKE_CXX_COMPILER=clang++
ninja -C "$directory" -j "$(nproc)" unit_tests
ctest --test-dir "$directory" -j "$(nproc)" -L '^unit$' --output-on-failure --no-tests=error
run-clang-tidy -quiet -j "$(nproc)" -p "$directory" >"$directory/clang_tidy.log" 2>&1 || {
  grep -A 4 'error: ' "$directory/clang_tidy.log"
  exit 1
}
