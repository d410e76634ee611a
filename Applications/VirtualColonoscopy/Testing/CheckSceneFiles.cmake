# Checks that a run without pending stages copies the requested results to the given names, byte-identically.
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT})
file(COPY ${FINISHED}/ DESTINATION ${OUT}/colon)
execute_process(COMMAND ${TOOL} ${INPUT} ${OUT}/colon --inputIsLumen --faces 20000 --quiet
    --wallModel ${OUT}/wall.vtp --centerlineCurve ${OUT}/line.mrk.json --candidatePoints ${OUT}/points.mrk.json
    --candidateTable ${OUT}/table.csv --flatPicture ${OUT}/flat.png
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "status ${status}: ${errors}")
endif()
foreach(pair "wall.vtp=landmarks/segments.vtp" "line.mrk.json=slicer/centerline.mrk.json"
    "points.mrk.json=polyps/candidates.mrk.json" "table.csv=polyps/candidates.csv" "flat.png=flattening/flat.png")
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 copy)
  list(GET pair 1 result)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${OUT}/${copy} ${OUT}/colon/${result} RESULT_VARIABLE different)
  if(NOT different EQUAL 0)
    message(FATAL_ERROR "${OUT}/${copy} differs from ${result}")
  endif()
endforeach()
