# cmake -DFILE=... -DPATTERN=... -P FileMatches.cmake: fails unless the text of the file matches the regular expression.
file(READ ${FILE} text)
if(NOT text MATCHES "${PATTERN}")
  message(FATAL_ERROR "${FILE} does not match ${PATTERN}:\n${text}")
endif()
