# shellcheck shell=bash
# What run-example.sh and run-tests.sh share; they source this file. The terminal gets one line per stage, the noise
# goes to one log under build/.

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

# Debian's tools first: another compiler or MPI does not match Debian's parallel HDF5, another Python lacks its modules.
export PATH="/usr/sbin:/usr/bin:/sbin:/bin:$PATH"
# shellcheck source=tools/environment.sh
. tools/environment.sh

# shellcheck disable=SC2034  # read by the scripts that source this file
build_packages=(g++ cmake ninja-build pkg-config git libopenmpi-dev openmpi-bin libhdf5-openmpi-dev libeigen3-dev
  libcli11-dev libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcairo2-dev libleptonica-dev libexif-dev libboost-dev
  zlib1g-dev libgtest-dev python3 python3-numpy python3-h5py python3-matplotlib)
# shellcheck disable=SC2034
test_packages=(python3-vtk9 valgrind clang libclang-rt-14-dev
  groff-base)
# The test of the job scripts is skipped without them.
# shellcheck disable=SC2034
slurm_packages=(slurm-wlm munge)

# stage TITLE COMMAND...: runs the command into the log and prints how long it took. A failure prints the end of the log
# and ends the script.
stage() {
  local title=$1 begin=$SECONDS
  shift
  printf '%-44s' "$title"
  printf '\n== %s: %s\n' "$title" "$*" >>"$log"
  if "$@" >>"$log" 2>&1 </dev/null; then
    printf '%4d s\n' $((SECONDS - begin))
  else
    printf 'failed. The end of the log:\n\n'
    tail -n 40 "$log"
    printf '\n%s failed. Log: %s\n' "$title" "$log"
    exit 1
  fi
}

apt_install() {
  export DEBIAN_FRONTEND=noninteractive
  # A fresh machine may be running apt on its own at first: wait for its lock.
  apt-get -o DPkg::Lock::Timeout=300 update &&
    apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "$@"
}

# missing_packages NAME...: prints those of the Debian packages that are not installed.
missing_packages() {
  local name installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
  for name in "$@"; do
    grep -qxF "installed $name" <<<"$installed" || echo "$name"
  done
}

# set_up NAME PACKAGE...: starts build/NAME.log anew and installs the Debian packages that are missing. Without root it
# names them and ends the script before anything is written.
set_up() {
  local name=$1 missing
  shift
  if ! command -v dpkg-query >/dev/null; then
    echo "This is no Debian. Install the counterparts of these packages and build with cmake --preset release: $*" >&2
    exit 1
  fi
  mapfile -t missing < <(missing_packages "$@")
  if ((${#missing[@]} > 0 && $(id -u) != 0)); then
    echo "Missing packages; as root: apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  mkdir -p build
  log=$root/build/$name.log
  : >"$log" || exit 1
  echo "Log: $log"
  if ((${#missing[@]} > 0)); then
    stage "Packages: installing ${#missing[@]} of $#" apt_install "${missing[@]}"
  else
    echo "Packages: all $# installed"
  fi
}

# build PRESET [OPTION...]: configures and builds a preset; the options go to the build.
build() {
  local preset=$1
  shift
  stage "Configure ($preset)" cmake --preset "$preset"
  stage "Build ($preset)" cmake --build --preset "$preset" --parallel "$(nproc)" "$@"
}
