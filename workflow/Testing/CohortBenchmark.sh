#!/bin/bash
# usage: CohortBenchmark [COUNT]
# Speedup of two parallel jobs: a cohort of COUNT small synthetic patients (default 12; two of them intentionally
# broken) on this machine, first
# one job at a time, then two. Each examination uses one thread. Prints the ratio of the run times, including the report.
# shellcheck source-path=SCRIPTDIR
source "$(dirname "$(realpath "${BASH_SOURCE[0]}")")/common.sh"

tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd) # this script is called through a link in the folder of the tools
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
count=${1:-12}

# with_jobs JOBS: run time of the whole cohort in seconds
with_jobs() {
  local begin
  mkdir -p "$folder/profile-$1"
  sed "s/^cores: .*/cores: $1/" "$workflow/profiles/local/config.yaml" >"$folder/profile-$1/config.yaml"
  begin=$EPOCHREALTIME
  "$repository/Utilities/run-cohort" "$folder/patients/cohort.tsv" "$folder/$1" --profile "$folder/profile-$1" --tools "$tools" \
    -- --faces 8000 --pixelSize 2 >"$folder/$1.txt" 2>&1 || { cat "$folder/$1.txt" >&2; exit 1; }
  awk "BEGIN { print $EPOCHREALTIME - $begin }"
}

# seconds_of COLUMN JOBS: of runs.tsv, all examinations
seconds_of() {
  awk -F '\t' -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i } { sum += $column } END { print sum }' \
    "$folder/$2/runs.tsv"
}

# row WHAT VALUE RELATION ASKED
row() {
  awk -v what="$1" -v value="$2" -v relation="$3" -v asked="$4" 'BEGIN {
    isMet = relation == ">=" ? value >= asked : value <= asked
    printf "%-66s %10.2f   asked %s %g   %s\n", what, value, relation, asked, isMet ? "met" : "NOT MET" }'
}

"$testing/make-patients" "$tools" "$folder/patients" "$count"
one=$(with_jobs 1)
two=$(with_jobs 2)
expect "results of two jobs" "$(cat "$folder/2/cohort.tsv")" "$(cat "$folder/1/cohort.tsv")"
printf '%d patients: one job %.1f s, two jobs %.1f s; processor time of the tools %.1f s and %.1f s\n' "$count" "$one" "$two" \
  "$(seconds_of processorSeconds 1)" "$(seconds_of processorSeconds 2)"
row "speedup of two jobs" "$(awk "BEGIN { print $one / $two }")" ">=" 1.7
row "overhead of the workflow per patient, s" "$(awk "BEGIN { print ($one - $(seconds_of seconds 1)) / $count }")" "<=" 3
