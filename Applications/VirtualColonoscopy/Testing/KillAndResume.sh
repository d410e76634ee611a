#!/bin/bash
# Called by ctest: KillAndResume.sh TOOL INPUT FINISHED FOLDER OPTIONS...
# Kills a run in FOLDER by SIGKILL in each of its stages and resumes it; the files must equal the files of FINISHED. Also:
# a second run in a locked folder is rejected.
set -u
tool=$1 input=$2 finished=$3 folder=$4
shift 4

fail() {
  echo "$*" >&2
  exit 1
}

# digests DIR: the SHA-256 of all files that equal runs share.
digests() {
  (cd "$1" && find . -type f ! -name '*run.json' ! -name .lock -print0 | sort -z | xargs -0 sha256sum)
}

rm -rf "$folder"
for stage in segmentation flattening landmarks folds report; do
  "$tool" "$input" "$folder" --quiet "$@" &
  run=$!
  while kill -0 "$run" 2>/dev/null && [ ! -e "$folder/.$stage.part" ]; do sleep 0.01; done
  [ -e "$folder/.$stage.part" ] || fail "the stage $stage was not observed running"
  kill -KILL "$run" 2>/dev/null || fail "the run ended before it could be killed in $stage"
  wait "$run" 2>/dev/null
  [ ! -e "$folder/stages/$stage.json" ] || fail "the stage $stage ended before it could be killed"
done
"$tool" "$input" "$folder" --quiet "$@" || fail "the resumed run exited with $?"
diff <(digests "$finished") <(digests "$folder") || fail "the files differ"
second=$(flock "$folder/.lock" "$tool" "$input" "$folder" --quiet "$@" 2>&1; echo "status $?")
[[ $second == *"another run is using"*"status 1" ]] || fail "unexpected message during another run: $second"
left=$(find "$folder" -name '.*.part*')
[ -z "$left" ] || fail "leftover files: $left"
