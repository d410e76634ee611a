# Shared functions of the scripts in this folder; to be sourced, not run.
# shellcheck shell=bash

set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
buildRoot=${SHAPETON_BUILD_DIR:-$repository/build}
export repository buildRoot

say() { printf '%s\n' "$*"; }

step() { printf '\n==> %s\n' "$*"; }

# fail MESSAGE [STATUS]: prints one line on stderr and exits; 2 is a usage error, 3 an unsuitable input, 1 everything else.
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}

# usage: prints the header comment of the calling script, which is its documentation.
usage() { sed -n '2,/^[^#]/{/^#/!d;s/^# \{0,1\}//;p;}' "$0"; }

# needs_value OPTION COUNT: COUNT is the number of remaining words, including the option.
needs_value() { [ "$2" -ge 2 ] || fail "$1 requires a value; see --help" 2; }

cores() { getconf _NPROCESSORS_ONLN; }

# build_jobs: number of parallel jobs; compiling ITK and VTK code takes up to 1.5 GB per job.
build_jobs() {
  local jobs memory
  jobs=$(cores)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  [ "$memory" -lt "$jobs" ] && jobs=$memory
  printf '%s\n' "$jobs"
}

# configure TREE [CMAKE ARGUMENTS...]: configures the tree of a preset of CMakePresets.json.
configure() {
  local tree=$1
  shift
  if ! mkdir -p "$buildRoot/$tree" 2>/dev/null || [ ! -w "$buildRoot/$tree" ]; then
    fail "cannot write $buildRoot; set SHAPETON_BUILD_DIR to a writable folder"
  fi
  (cd "$repository" && cmake --preset "$tree" -B "$buildRoot/$tree" "$@" >"$buildRoot/$tree/configure.log" 2>&1) || {
    cat "$buildRoot/$tree/configure.log" >&2
    fail "the configuration of $buildRoot/$tree failed; see above"
  }
}

# build TREE [TARGETS...]: builds the targets (default: all).
build() {
  local tree=$1
  shift
  cmake --build "$buildRoot/$tree" --parallel "$(build_jobs)" ${1:+--target "$@"} ||
    fail "the build of $buildRoot/$tree failed; see above"
}

# build_tools TOOLS...: installs missing packages, builds the tools and sets "tools" to their folder.
build_tools() {
  local testing=() # keep the tests of a tree made by run-tests
  "$repository/Utilities/install-dependencies" demo
  step "Building (the first time takes minutes)"
  [ -e "$buildRoot/release/CMakeCache.txt" ] || testing=(-DBUILD_TESTING=OFF)
  configure release "${testing[@]}"
  build release "${@/#/bin/}"
  tools=$buildRoot/release/bin
  export tools
}

# run_ctest FOLDER [CTEST ARGUMENTS...]: runs the tests of a build, prints the numbers of passed, skipped and failed tests, and
# returns the status of ctest.
run_ctest() {
  local folder=$1 results=$1/Testing/results.xml status=0
  shift
  rm -f "$results"
  (cd "$folder" && ctest --output-on-failure --no-tests=error --parallel "$(cores)" --output-junit "$results" "$@") || status=$?
  if [ -s "$results" ]; then
    step "Summary"
    awk -f "$repository/Utilities/test-summary.awk" "$results"
  fi
  return "$status"
}
