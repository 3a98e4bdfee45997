#!/bin/sh
# fuzz.sh PROGRAM KEPT_CORPUS: runs a fuzz target for SLOSH_FUZZ_SECONDS (60) from its kept corpus
# and from what its earlier runs added to that, in PROGRAM.corpus. An input that ends it badly is
# left beside that, as PROGRAM.crash-..., .timeout-..., .leak-... or .oom-...; PROGRAM FILE repeats it.
set -eu
mkdir -p "$1.corpus"
exec "$1" -max_total_time="${SLOSH_FUZZ_SECONDS:-60}" -timeout=10 -rss_limit_mb=2048 -max_len=16384 \
  -print_final_stats=1 -artifact_prefix="$1." "$1.corpus" "$2"
