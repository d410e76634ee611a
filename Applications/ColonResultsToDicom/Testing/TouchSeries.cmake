# A copy of SERIES with an additional file, which differs from the input of the run.
file(REMOVE_RECURSE ${OTHER})
file(COPY ${SERIES}/ DESTINATION ${OTHER})
file(WRITE ${OTHER}/note.txt "added after the run")
