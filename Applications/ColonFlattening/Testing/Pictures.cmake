# Pictures, coordinate map and report.
set(pictures ${Shapeton_BINARY_DIR}/Testing/Temporary/ColonFlatteningPictures)
file(REMOVE_RECURSE ${pictures})
file(MAKE_DIRECTORY ${pictures})
set(tube ${CMAKE_CURRENT_SOURCE_DIR}/Tube.off)

# ---- tube without a CT: all files, equal bytes for any number of threads ----
foreach(run All One)
  set(threads 0)
  if(run STREQUAL One)
    set(threads 1)
  endif()
  shapeton_tool_test(NAME ColonFlatteningPictures${run} COMMAND ColonFlattening ${tube} ${pictures}/flat${run}.vtp
    --picture ${pictures}/curvature${run}.png --coordinateMap ${pictures}/map${run}.nrrd --pixelSize 1.5
    --report ${pictures}/report${run} --threads ${threads})
endforeach()
set_tests_properties(ColonFlatteningPicturesAll ColonFlatteningPicturesOne PROPERTIES
  FIXTURES_SETUP ColonFlatteningPictures)
shapeton_tool_test(NAME ColonFlatteningRelief COMMAND ColonFlattening ${tube} ${pictures}/flat.vtp --coloring relief
  --picture ${pictures}/relief.png)
add_test(NAME ColonFlatteningPictureFiles COMMAND ${CMAKE_COMMAND} -DFOLDER=${pictures}
  -P ${CMAKE_CURRENT_SOURCE_DIR}/CheckPictures.cmake)
set_tests_properties(ColonFlatteningPictureFiles PROPERTIES LABELS Applications
  FIXTURES_REQUIRED ColonFlatteningPictures)

# ---- CT of the synthetic patient of ColonSegmentation ----
set(model ${Shapeton_BINARY_DIR}/Testing/Temporary/ColonSegmentation)
function(on_model name)
  shapeton_tool_test(NAME ColonFlattening${name}
    COMMAND ColonFlattening ${model}/ct/wall-simplified.vtp ${pictures}/${name}.vtp ${ARGN})
  set_tests_properties(ColonFlattening${name} PROPERTIES FIXTURES_REQUIRED "ColonPatient;ColonModelOfCt")
endfunction()
on_model(Cleansed --volume ${model}/ct/cleansed.nrrd --picture ${pictures}/cleansed.png --report ${pictures}/cleansed)
# Equal bytes on a GPU.
shapeton_compare_devices(ColonFlattening ${model}/ct/wall-simplified.vtp {OUT}/flat.vtp --volume ${model}/ct/cleansed.nrrd
  --picture {OUT}/flat.png --report {OUT}/report)
set_tests_properties(ColonFlatteningDevices ColonFlatteningGpu PROPERTIES FIXTURES_REQUIRED "ColonPatient;ColonModelOfCt")
on_model(Dicom --volume ${model}/patient --picture ${pictures}/dicom.png)

# ---- visually verified baselines ----
shapeton_compare_test(NAME ColonFlatteningCurvatureBaseline DEPENDS ColonFlatteningPicturesAll TOLERANCE 2 PIXELS 200
  OUTPUT ${pictures}/curvatureAll.png BASELINE ${CMAKE_CURRENT_SOURCE_DIR}/Baseline/curvature.png)
add_executable(CompareCoordinateMaps CompareCoordinateMaps.cxx)
shapeton_link_modules(CompareCoordinateMaps PRIVATE FlatColon ITKIOImageBase ITKIONRRD)
add_test(NAME ColonFlatteningCoordinateMapBaseline COMMAND CompareCoordinateMaps ${pictures}/mapAll.nrrd
  ${CMAKE_CURRENT_SOURCE_DIR}/Baseline/coordinateMap.nrrd 0.01)
set_tests_properties(ColonFlatteningCoordinateMapBaseline PROPERTIES LABELS Applications
  FIXTURES_REQUIRED ColonFlatteningPictures)

# ---- wrong use, wrong input ----
function(refuses_picture name status message)
  shapeton_tool_test(NAME ColonFlatteningRefuses${name} STATUS ${status} STDERR ${message}
    COMMAND ColonFlattening ${tube} ${pictures}/refused.vtp ${ARGN})
endfunction()
set(someCt ${Shapeton_SOURCE_DIR}/Data/PhantomSeries)
refuses_picture(VolumeAlone 2 "requires --picture or --report" --volume ${someCt})
refuses_picture(VolumeColoring 2 "requires --volume" --coloring volume --picture ${pictures}/refused.png)
refuses_picture(CudaWithoutCt 2 "remove --device cuda" --device cuda --picture ${pictures}/refused.png)
refuses_picture(MapName 2 "written as .nrrd" --coordinateMap ${pictures}/refused.nii)
refuses_picture(PixelSize 2 "pixelSize" --pixelSize 0 --picture ${pictures}/refused.png)
refuses_picture(OtherCt 3 "does not contain the surface" --volume ${someCt} --picture ${pictures}/refused.png)
refuses_picture(MissingCt 3 "absent" --volume ${pictures}/absent.nrrd --picture ${pictures}/refused.png)
refuses_picture(NoPlace 1 "nowhere" --picture /proc/nowhere/flat.png)
