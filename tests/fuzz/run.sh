#!/usr/bin/env bash
# Builds the fuzzers and runs each for SECONDS (default 60) from its seeds, with bounded memory and time per
# input. Fails on a finding, whose input stays in build/fuzz/findings.
#   tests/fuzz/run.sh [SECONDS [NAME...]]     NAME: as fuzz_points_ply; without any, all
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-60}
shift || true
cmake --preset fuzz >/dev/null
cmake --build build/fuzz -j2
names=("$@")
if [ ${#names[@]} -eq 0 ]; then
  for program in build/fuzz/tests/fuzz/fuzz_*; do
    [ -x "$program" ] && [ -f "$program" ] && names+=("$(basename "$program")")
  done
fi
mkdir -p build/fuzz/findings
failed=()
for name in "${names[@]}"; do
  found=build/fuzz/corpus/$name # what is found goes here, not among the seeds
  seeds=tests/fuzz/corpus/$name
  mkdir -p "$found"
  echo "== $name"
  build/fuzz/tests/fuzz/"$name" -max_total_time="$seconds" -max_len=4096 -timeout=10 -rss_limit_mb=2048 \
    -malloc_limit_mb=512 -print_final_stats=1 -verbosity=0 -artifact_prefix=build/fuzz/findings/"$name"- \
    "$found" "$seeds" 2>build/fuzz/"$name".log || failed+=("$name")
  grep -E '^stat::number_of_executed_units|^finding|ERROR|SUMMARY|runtime error' build/fuzz/"$name".log || true
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "findings: ${failed[*]}; see build/fuzz/findings and build/fuzz/NAME.log"
  exit 1
fi
echo "no findings"
