# Checks that the preview is updated repeatedly during a run, always with a complete picture, and that a killed run
# leaves the last preview and the last checkpoint, but no partial files.
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT})
file(WRITE ${OUT}/density.nrrd "the old result")
execute_process(COMMAND timeout -s TERM 4 ${TOOL} ${INPUT} ${OUT}/density.nrrd --preset published --timeSteps 1000000000 --shapetons 1000
  --preview ${OUT}/now.png --previewEvery 0.2 --quiet RESULT_VARIABLE status ERROR_QUIET)
if(status EQUAL 0)
  message(FATAL_ERROR "the run ended before it could be killed")
endif()
file(READ ${OUT}/density.nrrd content)
file(READ ${OUT}/now.png begin LIMIT 8 HEX)
file(GLOB left LIST_DIRECTORIES true RELATIVE ${OUT} ${OUT}/* ${OUT}/.*)
list(REMOVE_ITEM left . ..)
if(NOT content STREQUAL "the old result" OR NOT begin STREQUAL "89504e470d0a1a0a" OR NOT left STREQUAL "density.nrrd;now.png")
  message(FATAL_ERROR "density.nrrd contains [${content}], the preview begins with ${begin}, the folder contains [${left}]")
endif()
