#!/bin/sh
# A term that a scene leaves out executes no instruction: a short run of each scene calls those of the listed functions
# that belong to its terms and no others, by callgrind's record of all functions called. Each of the 17 takes a second.
# Usage: absent_terms_test.sh PROGRAM FUNCTIONS [--must-fail]
#   --must-fail  checks that the test can fail: it must fail for a function that is called and listed as absent, and for
#                one that is not called and listed as present
# Exit status: 0 passed, 1 failed, 77 skipped because there is no valgrind.
set -eu

program=$1 functions=$2
if ! command -v valgrind >/dev/null; then
  echo "SKIPPED: valgrind is not installed"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

called() {  # SCENE; prints the names of the functions that its run calls
  OMP_NUM_THREADS=1 valgrind --tool=callgrind --callgrind-out-file="$work/out" "$program" "$1" 0.01 \
    >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  sed -n 's/^c\{0,1\}fn=([0-9]*) //p' "$work/out"
}

# Reads the names from $work/called.
check() {  # SCENE FUNCTIONS
  sed 's/#.*//' "$2" | awk -F' *[|] *' -v scene="$1" '
    FNR == NR { called = called "\n" $0; next }
    NF == 2 {
      names = " " $2 " "
      own = index(names, " " scene " ") > 0
      if (sub(/^ all but /, " ", names)) own = !own
      is_called = index(called, $1) > 0
      if (is_called != own) {
        printf "FAILS: %s %s %s\n", scene, is_called ? "calls" : "does not call", $1
        failed = 1
      }
      ++checked
    }
    END {
      if (!failed && checked) printf "%s calls what is its own of %d functions\n", scene, checked
      exit failed || !checked
    }' "$work/called" -
}

if [ "${3-}" = --must-fail ]; then
  called recommended >"$work/called"
  for wrong in 'MomentumOfCluster | antuono' 'sum_density_gradient | recommended'; do
    echo "$wrong" >"$work/wrong"
    if check recommended "$work/wrong"; then echo "FAILED: passed \"$wrong\""; exit 1; fi
  done
  exit 0
fi

status=0
for scene in recommended still no_gauge antuono ghost_walls baffle plate roll dam narrow_tank pressure_gauge \
  energy_budget still_water snapshots saved_states li2010 zhao2021_moving+roll; do
  # The plate is thinner than the spacing of coarse particles.
  case $scene in plate) spacing= ;; *) spacing=+coarse ;; esac
  called "$scene$spacing" >"$work/called"
  check "$scene" "$functions" || status=1
done
exit $status
