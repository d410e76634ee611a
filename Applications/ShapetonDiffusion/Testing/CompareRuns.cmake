# Checks that all files except the run record are byte-identical for 1, 2, 3 and 8 threads, and for a run in two parts.
set(options --preset published --directionSampling solidAngle --shapetons 20000 --distance 0.03 --seed 5 --quiet)
set(results --labels labels.nrrd --classTable classes.csv --checkpoint end.state)

function(run folder)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${TOOL} ${INPUT} density.nrrd ${options} ${ARGN} WORKING_DIRECTORY ${folder}
    RESULT_VARIABLE status ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${folder}: status ${status}: ${errors}")
  endif()
endfunction()

function(compare folder other)
  foreach(file IN LISTS ARGN)
    file(SHA256 ${folder}/${file} hash)
    file(SHA256 ${other}/${file} otherHash)
    if(NOT hash STREQUAL otherHash)
      message(FATAL_ERROR "${file} differs between ${folder} and ${other}")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE ${OUT})
foreach(threads 1 2 3 8)
  run(${OUT}/${threads} ${results} --timeSteps 300 --report report --threads ${threads})
  file(GLOB_RECURSE files RELATIVE ${OUT}/${threads} ${OUT}/${threads}/*)
  list(REMOVE_ITEM files density.nrrd.run.json)
  list(LENGTH files number)
  if(number LESS 10)
    message(FATAL_ERROR "only ${number} files: ${files}")
  endif()
  compare(${OUT}/1 ${OUT}/${threads} ${files})
endforeach()

# The second part replaces the state of the first.
run(${OUT}/parts --checkpoint end.state --timeSteps 117)
run(${OUT}/parts ${results} --timeSteps 300 --resume end.state --preview now.png --previewEvery 0.5)
compare(${OUT}/1 ${OUT}/parts density.nrrd labels.nrrd classes.csv end.state)
