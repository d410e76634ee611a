# Functions of the checks in this folder; sourced, not executed.
# shellcheck shell=bash

set -euo pipefail

testing=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
workflow=$(dirname "$testing")
repository=$(dirname "$workflow")
export testing workflow repository

# need_packages LEVEL...: skips the check if a package of Utilities/install-dependencies is missing; ctest searches for
# "skipped: ".
need_packages() {
  local level package
  while read -r level package _; do
    [[ " $* " == *" $level "* ]] || continue
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || {
      echo "skipped: $package is not installed; see Utilities/install-dependencies $level"
      exit 0
    }
  done < <("$repository/Utilities/install-dependencies" --list)
}

need_root() {
  [ "$(id -u)" -eq 0 ] || { echo "skipped: $1 requires root"; exit 0; }
}

# expect WHAT ACTUAL WANTED
expect() {
  [ "$2" = "$3" ] || { printf '%s: is\n%s\nand should be\n%s\n' "$1" "$2" "$3" >&2; exit 1; }
}

# end_processes PID-FILE...: ends the processes of a check, and waits for their end.
end_processes() {
  local file pid
  for file in "$@"; do
    [ -s "$file" ] || continue
    pid=$(cat "$file")
    kill "$pid" 2>/dev/null || continue
    while kill -0 "$pid" 2>/dev/null; do sleep 0.1; done
  done
}
