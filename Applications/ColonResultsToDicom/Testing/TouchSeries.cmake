# A copy of SERIES with one more file: what the run read is no longer what lies there.
file(REMOVE_RECURSE ${OTHER})
file(COPY ${SERIES}/ DESTINATION ${OTHER})
file(WRITE ${OTHER}/note.txt "not there when the run was made")
