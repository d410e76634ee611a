# Called by ctest: polyps follow folds, also if these fail. One fails and the other is kept; then both fail.
file(REMOVE_RECURSE ${OUT} ${OUT}Tools)
file(COPY ${FINISHED}/ DESTINATION ${OUT})
get_filename_component(tools ${TOOL} DIRECTORY)
file(COPY ${TOOL} DESTINATION ${OUT}Tools) # it takes the others from its folder
foreach(other ColonSegmentation ColonFlattening ColonLandmarks ColonPolyps)
  file(CREATE_LINK ${tools}/${other} ${OUT}Tools/${other} SYMBOLIC)
endforeach()

function(let_fail tool)
  file(REMOVE ${OUT}Tools/${tool})
  file(WRITE ${OUT}Tools/${tool} "#!/bin/sh\n[ \"$1\" = --version ] || { echo '${tool}: no colon' >&2; exit 3; }\n")
  file(CHMOD ${OUT}Tools/${tool} PERMISSIONS OWNER_READ OWNER_EXECUTE)
endfunction()

function(expect expected)
  execute_process(COMMAND ${OUT}Tools/VirtualColonoscopy ${INPUT} ${OUT} --inputIsLumen --faces 20000 --quiet ${ARGN}
    RESULT_VARIABLE status ERROR_VARIABLE error)
  file(READ ${OUT}/report.html report)
  string(FIND "${report}" "${expected}" inReport)
  string(FIND "${error}" "${expected}" inError)
  if(NOT status EQUAL 3 OR inReport EQUAL -1 OR inError EQUAL -1)
    message(FATAL_ERROR "status ${status}: ${error}")
  endif()
endfunction()

let_fail(ColonFolds)
foreach(threads 2 1)
  file(REMOVE ${OUT}/stages/polyps.json)
  expect("the stage folds (ColonFolds) failed: no colon; kept: segmentation, flattening, landmarks, polyps, report.html"
    --threads ${threads})
endforeach()
if(NOT EXISTS ${OUT}/stages/polyps.json)
  message(FATAL_ERROR "the polyps were not kept")
endif()
let_fail(ColonPolyps)
expect("the stage folds (ColonFolds) failed: no colon; so did polyps (ColonPolyps): no colon; kept: segmentation")
