#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors, and runs the tests; see usage below.
# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

usage="usage: tools/run-tests.sh [--slow | --all] [--asan]
  (none)   every test but those labelled slow, and the unit tests a second time, on 1 and 2 ranks, under the address
           and undefined-behaviour sanitizers; less than 45 minutes on 2 cores
  --slow   the tests labelled slow instead
  --all    every test
  --asan   all of the chosen tests a second time under the sanitizers"

# run_ctest PRESET OPTION...: the tests that the options choose, one line for each on the terminal, the output of those that fail, ctest's verdict.
run_ctest() {
  echo "Tests ($1):"
  if ! ctest --preset "$@" --parallel "$(nproc)" 2>&1 </dev/null | tee -a "$log" |
    grep --line-buffered -v '^ *Start '; then
    echo "Tests ($1) failed. Log: $log"
    exit 1
  fi
}

chosen=(-LE '^slow$')
sanitized=(-L '^sanitized$')
sanitized_target=(--target sanitized_tests)
for option in "$@"; do
  case $option in
    --slow) chosen=(-L '^slow$') ;;
    --all) chosen=() ;;
    --asan) sanitized=() sanitized_target=() ;;
    -h | --help) echo "$usage" && exit 0 ;;
    *) echo "$usage" >&2 && exit 2 ;;
  esac
done

set_up run-tests "${build_packages[@]}" "${test_packages[@]}"
build ci
run_ctest ci "${chosen[@]}"
if ((${#sanitized[@]} == 0)); then
  build asan
  run_ctest asan "${chosen[@]}"
elif [[ ${chosen[*]} != *"-L ^slow"* ]]; then
  build asan "${sanitized_target[@]}"
  run_ctest asan "${sanitized[@]}"
fi
