# Summarizes ctest's JUnit file: counts tests, lists failed ones, and groups skipped ones by reason. The reason is the line
# after "...: Skipped" for GoogleTest, the last line for other tests.

function attribute(name) {
  if (!match($0, " " name "=\"[^\"]*\"")) return ""
  return substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 4)
}

function plain(text) {
  gsub(/&lt;/, "<", text)
  gsub(/&gt;/, ">", text)
  gsub(/&quot;/, "\"", text)
  gsub(/&amp;/, "\\&", text)
  return text
}

/<testcase / {
  inside = 1
  test = attribute("name")
  status = attribute("status")
  reason = ""
  followsMark = complete = asked = 0
}

/<skipped message="SKIP_/ { asked = 1 } # a test that did not run because its program is missing counts as failed

inside {
  line = $0
  sub(/.*<system-out>/, "", line)
  sub(/<\/system-out>.*/, "", line)
  if (line ~ /: Skipped$/) followsMark = 1
  else if (line !~ /^[ \t]*(<.*)?$/ && line !~ /^\[ / && !complete) {
    reason = line
    complete = followsMark
  }
}

/<\/testcase>/ {
  inside = 0
  ++tests
  if (status == "run") ++passed
  else if (status == "disabled" || asked) {
    ++skipped
    reason = plain(reason == "" ? "no reason given" : reason)
    ++count[reason]
    names[reason] = names[reason] "\n    " test
  }
  else failed = failed "\n    " test
}

END {
  printf "%d tests: %d passed, %d skipped, %d failed\n", tests, passed, skipped, tests - passed - skipped
  for (reason in count) printf "  %d skipped: %s%s\n", count[reason], reason, names[reason]
  if (failed != "") printf "  failed:%s\n", failed
}
