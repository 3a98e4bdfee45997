#!/bin/sh
# In the table of terms, leaving a term out lowers the count of instructions and adding one raises it.
# Usage: terms_table_test.sh PROGRAM [--must-fail]
#   --must-fail  checks that the test can fail: it must fail for the reverse order
# Exit status: 0 passed, 1 failed, 77 skipped because there is no valgrind.
set -eu

program=$1
if ! command -v valgrind >/dev/null; then
  echo "SKIPPED: valgrind is not installed"
  exit 77
fi
scenes='no_viscosity recommended'
[ "${2-}" = --must-fail ] || scenes="$scenes no_diffusion antuono pressure_gauge"
# shellcheck disable=SC2086 # words
table=$("$(dirname "$0")/terms_table.sh" "$program" $scenes 2>/dev/null)

instructions() {  # SCENE
  echo "$table" | awk -F' *[|] *' -v scene="\`$1\`" '$2 == scene {print $4}'
}

fewer() {  # SCENE SCENE; fails for a missing count
  awk -v a="$(instructions "$1")" -v b="$(instructions "$2")" -v names="$1 $2" 'BEGIN {
    held = a > 0 && b > 0 && a + 0 < b + 0
    printf "%s: %s and %s instructions per particle and step: %s\n", names, a, b, held ? "fewer" : "NOT FEWER"
    exit !held }'
}

if [ "${2-}" = --must-fail ]; then
  if fewer recommended no_viscosity; then echo "FAILED: passed the order turned round"; exit 1; fi
  exit 0
fi
status=0
fewer no_viscosity recommended || status=1
fewer no_diffusion recommended || status=1
fewer recommended antuono || status=1
fewer recommended pressure_gauge || status=1
exit $status
