#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors, and runs the tests; see usage below.
# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

usage="usage: tools/run-tests.sh [--slow | --all] [--asan]
  (none)   every test but those labelled slow; the unit tests a second time, those that communicate on 2 ranks too, under
           the address and undefined-behaviour sanitizers of clang; in the same build each fuzz target for 20 s. Less than
           45 minutes on 2 cores
  --slow   the tests labelled slow instead, and each fuzz target for 5 minutes; in a build of the preset release, which
           compiles each source by itself and so finds an include that is missing
  --all    every test
  --asan   all of the chosen tests a second time under the sanitizers"

# run_ctest PRESET OPTION...: the tests that the options choose, one line for each on the terminal, the output of those
# that fail, ctest's verdict.
run_ctest() {
  echo "Tests ($1):"
  if ! ctest --preset "$@" --parallel "$(nproc)" 2>&1 </dev/null | tee -a "$log" |
    grep --line-buffered -v '^ *Start '; then
    echo "Tests ($1) failed. Log: $log"
    exit 1
  fi
}

preset=ci
chosen=(-LE '^slow$')
for option in "$@"; do
  case $option in
    --slow) preset=release chosen=(-L '^slow$') only_slow=yes ;;
    --all) chosen=() ;;
    --asan) everything_sanitized=yes ;;
    -h | --help) echo "$usage" && exit 0 ;;
    *) echo "$usage" >&2 && exit 2 ;;
  esac
done

targets=(sanitized_tests fuzz)
sanitized=("${chosen[@]}" -L '^(sanitized|fuzz)$')
if [[ -n ${everything_sanitized:-} ]]; then
  targets=(all)
  sanitized=("${chosen[@]}")
elif [[ -n ${only_slow:-} ]]; then
  targets=(fuzz)
  sanitized=("${chosen[@]}" -L '^fuzz$')
fi

# Without root the test of the job scripts is skipped where SLURM is not there.
optional=()
if (($(id -u) == 0)); then optional=("${slurm_packages[@]}"); fi
set_up run-tests "${build_packages[@]}" "${test_packages[@]}" "${optional[@]}"
build "$preset"
run_ctest "$preset" "${chosen[@]}"
build asan --target "${targets[@]}"
run_ctest asan "${sanitized[@]}"
