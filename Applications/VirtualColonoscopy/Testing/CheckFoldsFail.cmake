# Called by ctest: the search for folds fails while that for polyps goes on beside it; both are told, polyps are kept.
file(REMOVE_RECURSE ${OUT} ${OUT}Tools)
file(COPY ${FINISHED}/ DESTINATION ${OUT})
file(REMOVE ${OUT}/stages/polyps.json)
get_filename_component(tools ${TOOL} DIRECTORY)
file(COPY ${TOOL} DESTINATION ${OUT}Tools) # it takes the others from its folder
foreach(other ColonSegmentation ColonFlattening ColonLandmarks ColonPolyps)
  file(CREATE_LINK ${tools}/${other} ${OUT}Tools/${other} SYMBOLIC)
endforeach()
file(WRITE ${OUT}Tools/ColonFolds "#!/bin/sh\n[ \"$1\" = --version ] || { echo 'ColonFolds: no colon' >&2; exit 3; }\n")
file(CHMOD ${OUT}Tools/ColonFolds PERMISSIONS OWNER_READ OWNER_EXECUTE)
execute_process(COMMAND ${OUT}Tools/VirtualColonoscopy ${INPUT} ${OUT} --inputIsLumen --faces 20000 --quiet
  RESULT_VARIABLE status ERROR_VARIABLE error)
set(expected
  "the stage folds .ColonFolds. failed: no colon; kept: segmentation, flattening, landmarks, polyps, report.html")
if(NOT status EQUAL 3 OR NOT error MATCHES "${expected}")
  message(FATAL_ERROR "status ${status}: ${error}")
endif()
if(NOT EXISTS ${OUT}/stages/polyps.json)
  message(FATAL_ERROR "the polyps were not kept")
endif()
