#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors, and runs the tests; see usage below.
# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

usage="usage: tools/run-tests.sh [--slow | --all] [--asan]
  (none)   every test but those labelled slow, and each fuzz target for 20 s; less than 50 minutes on 2 cores
  --slow   the tests labelled slow instead, and each fuzz target for 5 minutes
  --all    every test
  --asan   the same tests a second time under the address and undefined-behaviour sanitizers"

# run_ctest PRESET: the chosen tests, one line for each on the terminal, the output of those that fail, ctest's verdict.
run_ctest() {
  echo "Tests ($1):"
  if ! ctest --preset "$1" "${chosen[@]}" --parallel "$(nproc)" 2>&1 </dev/null | tee -a "$log" |
    grep --line-buffered -v '^ *Start '; then
    echo "Tests ($1) failed. Log: $log"
    exit 1
  fi
}

chosen=(-LE '^slow$')
presets=(ci)
for option in "$@"; do
  case $option in
    --slow) chosen=(-L '^slow$') ;;
    --all) chosen=() ;;
    --asan) presets+=(asan) ;;
    -h | --help) echo "$usage" && exit 0 ;;
    *) echo "$usage" >&2 && exit 2 ;;
  esac
done

presets+=(fuzz)
set_up run-tests "${build_packages[@]}" "${test_packages[@]}"
for preset in "${presets[@]}"; do
  build "$preset"
  run_ctest "$preset"
done
