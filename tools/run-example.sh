#!/usr/bin/env bash
# Installs what is missing, builds, and runs the quick discharge test on 2 ranks. Usage: tools/run-example.sh
# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

if (($# > 0)); then
  echo "usage: tools/run-example.sh" >&2
  exit 2
fi

output=results/discharge_quick
set_up run-example "${build_packages[@]}"
build release --target repose

echo "Run input/discharge_quick.toml on 2 ranks:"
if ! mpirun -n 2 build/release/src/repose run input/discharge_quick.toml --output "$output" 2>&1 </dev/null |
  tee -a "$log"; then
  echo "The run failed. Log: $log" >&2
  exit 1
fi
echo
/usr/bin/python3 tools/print_summary.py "$output/summary.json" | tee -a "$log"
echo "All files of the run: $root/$output"
