# Joins the scripts of a page into a C++ source; needs no JavaScript tools.
#
# cmake -DOUT=F.cxx -DNAME=N "-DFILES=a.mjs;b.mjs" [-DSTART=statement] -P ShapetonScripts.cmake
#
# ES modules, in the order of their dependencies, become one classic script in a function of its own, because a browser refuses
# modules from file://. The lines "import ..." and the words "export" go, so names at the top level have to be unique. Other
# files, such as styles, are joined as they are. F.cxx defines the array shapeton::N of pieces, as no compiler has to take longer
# literals than 64 kB; beside it lies the text as F.txt.
set(text "")
foreach(file IN LISTS FILES)
  file(READ "${file}" part)
  if(file MATCHES "\\.mjs$")
    string(REGEX REPLACE "(^|\n)import [^;]*;" "\\1" part "${part}")
    string(REGEX REPLACE "(^|\n)export " "\\1" part "${part}")
  endif()
  string(APPEND text "${part}\n")
endforeach()
if(FILES MATCHES "\\.mjs")
  set(text "(() => {\n'use strict';\n${text}${START}\n})();\n")
endif()
if(text MATCHES "\\)piece\"" OR text MATCHES "</(script|style)")
  message(FATAL_ERROR "a script holds the end of a C++ literal or of its element")
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
