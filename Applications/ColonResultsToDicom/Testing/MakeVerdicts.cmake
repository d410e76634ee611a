# Writes verdicts as saved by the page of ColonViewer for EXAM: OUT/partial.json, in which candidate 1 is a polyp and the
# others are unread, and OUT/complete.json, in which the others are rejected.
set(digests "")
foreach(name flattening/flat.vtp polyps/candidates.csv)
  file(SHA256 ${EXAM}/${name} digest)
  string(APPEND digests ${digest})
endforeach()
string(SHA256 exam "${digests}")
file(STRINGS ${EXAM}/polyps/candidates.csv rows)
list(LENGTH rows last)
math(EXPR last "${last} - 1") # the first row is the header
set(others "")
foreach(number RANGE 2 ${last})
  string(APPEND others ", {\"id\": \"${number}\", \"verdict\": \"not a polyp\", \"note\": \"\"}")
endforeach()
set(first "{\"id\": \"1\", \"verdict\": \"polyp\", \"note\": \"größer\", \"size\": 12.5, \"morphology\": \"pedunculated\"}")
set(finding "{\"id\": \"F1\", \"position\": 0, \"lps\": [10, 20, -30.5], \"uv\": [1, 2], \"diameter\": null,
  \"note\": \"\", \"segment\": \"cecum\", \"arcLength\": null, \"morphology\": \"\"}")
foreach(kind partial complete)
  set(list ${first})
  set(colonic "C3")
  set(extracolonic "")
  if(kind STREQUAL "complete")
    string(APPEND list ${others})
    set(colonic "C2b")
    set(extracolonic "E1/E2")
  endif()
  file(WRITE ${OUT}/${kind}.json "{\"version\": 2, \"exam\": {\"seriesUIDs\": [], \"sha256\": \"${exam}\"},
    \"assessment\": {\"colonic\": \"${colonic}\", \"extracolonic\": \"${extracolonic}\", \"note\": \"\"},
    \"candidates\": [${list}], \"findings\": [${finding}], \"bookmarks\": []}")
endforeach()
