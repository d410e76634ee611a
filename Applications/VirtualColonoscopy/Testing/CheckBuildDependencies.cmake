# Checks that all tools run by VirtualColonoscopy are built with it: each declared tool, and each in the records of
# finished runs, is an input of its target.
# cmake -DNINJA=... -DBUILD=... -DTOOL=... "-DTOOLS=...;..." "-DRUNS=FOLDER;..." -P CheckBuildDependencies.cmake
set(tools ${TOOLS})
foreach(run IN LISTS RUNS)
  file(GLOB records ${run}/stages/*.json)
  if(NOT records)
    message(FATAL_ERROR "${run} has no records of stages")
  endif()
  foreach(record IN LISTS records)
    file(READ ${record} text)
    string(JSON tool ERROR_VARIABLE isOther GET "${text}" signature program) # the report has a record without a tool
    if(NOT isOther)
      list(APPEND tools ${tool})
    endif()
  endforeach()
endforeach()
list(REMOVE_DUPLICATES tools)

file(RELATIVE_PATH target ${BUILD} ${TOOL})
execute_process(COMMAND ${NINJA} -C ${BUILD} -t inputs ${target} OUTPUT_VARIABLE inputs RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "ninja -t inputs ${target}: status ${status}")
endif()
foreach(tool IN LISTS tools)
  if(NOT "${inputs}" MATCHES "bin/${tool}\n")
    message(FATAL_ERROR "VirtualColonoscopy runs ${tool}, but building it does not build ${tool}")
  endif()
endforeach()
