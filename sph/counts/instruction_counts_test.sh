#!/bin/sh
# Counts the instructions of a short run of each scheme under valgrind, which the load of the machine does not disturb,
# and compares them with instruction_counts.txt. More than 3 % above is a failure; more than 3 % below calls for a new
# count. Each scheme takes six seconds there.
# Usage: instruction_counts_test.sh PROGRAM COUNTS COMPILER [--must-fail]
#   --must-fail  checks that the test can fail: it must fail against a count that is 4 % lower
# Exit status: 0 passed, 1 failed, 77 skipped because there is no valgrind, or no count for this compiler and
# instruction set.
set -eu

program=$1 counts=$2 compiler=$3
if ! command -v valgrind >/dev/null; then
  echo "SKIPPED: valgrind is not installed"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

count() {  # SCHEME; writes what the run prints to $work/facts
  OMP_NUM_THREADS=1 valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" 0.03 \
    >"$work/facts" 2>"$work/log" || { cat "$work/log" >&2; exit 1; }
  sed -n 's/.*Collected : \([0-9]*\).*/\1/p' "$work/log"
}

# Lines of the counts: compiler | instruction set | scheme | instructions | reason
status=77
for scheme in $(sed 's/#.*//' "$counts" | awk -F' *[|] *' -v c="$compiler" '$1 == c {print $3}' | sort -u); do
  now=$(count "$scheme")
  set=$(sed -n 's/^instruction set|//p' "$work/facts")
  before=$(sed 's/#.*//' "$counts" |
    awk -F' *[|] *' -v c="$compiler" -v i="$set" -v s="$scheme" '$1 == c && $2 == i && $3 == s {print $4}')
  if [ -z "$before" ]; then continue; fi
  [ "$status" != 77 ] || status=0
  if [ "${4-}" = --must-fail ]; then before=$((before * 100 / 104)); fi
  awk -v scheme="$scheme" -v set="$set" -v now="$now" -v before="$before" 'BEGIN {
    change = 100 * (now / before - 1)
    # The comparison is false for NaN, which therefore fails.
    verdict = now > 0 && change <= 3 ? "holds" : "FAILS"
    if (verdict == "holds" && change < -3) verdict = "holds; enter the lower count"
    printf "%-12s %-7s %12d instructions, %+.2f %% against %d: %s\n", scheme, set, now, change, before, verdict
    exit verdict == "FAILS" }' || status=1
  [ "${4-}" != --must-fail ] || break  # one will do
done
if [ $status = 77 ]; then echo "SKIPPED: no count for $compiler and this processor's instruction set in $counts"; fi
if [ "${4-}" = --must-fail ] && [ $status != 77 ]; then
  if [ $status = 0 ]; then echo "FAILED: 4 % too many were let pass"; exit 1; fi
  exit 0
fi
exit $status
