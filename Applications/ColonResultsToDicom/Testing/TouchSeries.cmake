# Copies SERIES and adds a file, so that the copy differs from the input of the run.
file(REMOVE_RECURSE ${OTHER})
file(COPY ${SERIES}/ DESTINATION ${OTHER})
file(WRITE ${OTHER}/note.txt "added after the run")
