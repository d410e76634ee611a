# Joins the scripts of a page into a C++ source, without JavaScript tools.
#
# cmake -DOUT=F.cxx -DNAME=N "-DFILES=a.mjs;b.mjs" [-DSTART=statement] -P ShapetonScripts.cmake
#
# ES modules, in dependency order, are combined into one classic script inside a function, because browsers reject modules from
# file://. The lines "import ...", lines of comments and the words "export" are removed, so top-level names must be unique. Other
# files, such as styles, are joined unchanged. F.cxx defines the array shapeton::N of pieces, because compilers may not support
# literals longer than 64 kB; F.txt contains the whole text.
set(text "")
foreach(file IN LISTS FILES)
  file(READ "${file}" part)
  if(file MATCHES "\\.mjs$")
    string(REGEX REPLACE "(^|\n)import [^;]*;" "\\1" part "${part}")
    string(REGEX REPLACE "(^|\n)export " "\\1" part "${part}")
    string(REGEX REPLACE "\n *//[^\n]*" "" part "${part}")
  endif()
  string(APPEND text "${part}\n")
endforeach()
if(FILES MATCHES "\\.mjs")
  set(text "(() => {\n'use strict';\n${text}${START}\n})();\n")
endif()
if(text MATCHES "\\)piece\"" OR text MATCHES "</(script|style)")
  message(FATAL_ERROR "a script contains the end of a C++ literal or of a script or style element")
endif()
string(REGEX REPLACE "\\.cxx$" ".txt" plain "${OUT}")
file(WRITE "${plain}" "${text}")
string(LENGTH "${text}" length)
set(code "namespace shapeton\n{\nextern const char * const ${NAME}[];\nconst char * const        ${NAME}[] = {\n")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 8000 part)
  string(APPEND code "R\"piece(${part})piece\",\n")
  math(EXPR at "${at} + 8000")
endwhile()
file(WRITE "${OUT}" "${code}nullptr };\n} // namespace shapeton\n")
