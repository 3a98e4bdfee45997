#!/bin/sh
# The guards of a run (sph/guards/) take less than 1 % of its instructions, by callgrind's count of a short run of each
# scheme.
# Usage: guard_share_test.sh PROGRAM [--must-fail]
#   --must-fail  checks that the test can fail, against a limit of 0.01 %
# Exit status: 0 passed, 1 failed, 77 skipped because there is no valgrind.
set -eu

program=$1
if ! command -v valgrind >/dev/null; then
  echo "SKIPPED: valgrind is not installed"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
most=1
if [ "${2-}" = --must-fail ]; then most=0.01; fi

share_holds() {  # SCHEME
  OMP_NUM_THREADS=1 valgrind --tool=callgrind --callgrind-out-file="$work/out" "$program" "$1" 0.05 \
    >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  callgrind_annotate --threshold=100 "$work/out" | tr -d , | awk -v scheme="$1" -v most="$most" '
    /PROGRAM TOTALS/ { total = $1 }
    /check_state|check_step|EnergyBound::check/ { guards += $1 }
    END {
      share = total > 0 ? 100 * guards / total : 100
      # Guards that are not found count as too much.
      verdict = guards > 0 && share <= most ? "holds" : "FAILS"
      printf "%-12s guards %d of %d instructions, %.2f %% <= %s %%: %s\n", scheme, guards, total, share, most, verdict
      exit verdict == "FAILS"
    }'
}

status=0
for scheme in recommended li2010; do share_holds "$scheme" || status=1; done
if [ "${2-}" = --must-fail ]; then
  if [ $status = 0 ]; then echo "FAILED: a share above the limit was let pass"; exit 1; fi
  exit 0
fi
exit $status
