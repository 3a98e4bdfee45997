#!/bin/sh
# Runs the checks of .clang-tidy on all sources of the project but its tests. First it shows, on a source with a defect,
# that the checks find one. Exit status: 0 where nothing is found; 77 (skipped) where clang-tidy is not installed.
# Usage: clang_tidy.sh SOURCE_TREE DIRECTORY
set -eu
if ! command -v run-clang-tidy >/dev/null || ! command -v clang++ >/dev/null; then
  echo "skipped: clang-tidy or clang is not installed"
  exit 77
fi

# The headers are compiled with each source: clang-tidy cannot read those that another compiler has precompiled.
cmake -S "$1" --preset release -B "$2" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON

cat >"$2/used_after_move.cpp" <<'END'
#include <string>
#include <utility>
std::string twice(std::string text) {
  std::string other = std::move(text);
  return other + text;
}
END
if clang-tidy -quiet --config-file="$1/.clang-tidy" "$2/used_after_move.cpp" -- -std=c++20 >"$2/used_after_move.log" 2>&1
then
  echo "FAILED: a value that is used after its move was not found"
  exit 1
fi
grep -q bugprone-use-after-move "$2/used_after_move.log" || { cat "$2/used_after_move.log"; exit 1; }

run-clang-tidy -quiet -j "$(nproc)" -p "$2" '/slosh_[a-z_]+\.dir/|/(sph|reference|openfoam_cases|verification|reports)/([a-z_]+/)*[a-z_]+(?<!_test)(?<!_fuzz)\.cpp$' \
  >"$2/clang_tidy.log" 2>/dev/null || {
  grep -A 3 ' error: ' "$2/clang_tidy.log"
  exit 1
}
