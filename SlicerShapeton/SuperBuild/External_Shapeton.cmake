# Libraries and tools in Slicer's layout: tools in cli-modules, libraries one folder above.
set(proj Shapeton)
set(${proj}_DEPENDS BZip2 Boost Eigen3 METIS OpenCV SQLite3 Spectra nauty nlohmann_json)
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
set(inner ${CMAKE_BINARY_DIR}/${EXTENSION_BUILD_SUBDIRECTORY})
set(opencv_lib ${inner}/${Slicer_THIRDPARTY_LIB_DIR})
if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/../Modules/Filtering/Heat)
  set(source DOWNLOAD_COMMAND "" SOURCE_DIR ${CMAKE_CURRENT_SOURCE_DIR}/..)
elseif(Shapeton_GIT_REPOSITORY)
  set(source GIT_REPOSITORY ${Shapeton_GIT_REPOSITORY} GIT_TAG ${Shapeton_GIT_TAG} SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj})
else()
  message(FATAL_ERROR "The sources of Shapeton are not in the folder above; set Shapeton_GIT_REPOSITORY and Shapeton_GIT_TAG")
endif()
ExternalProject_Add(${proj}
  ${${proj}_EP_ARGS}
  ${source}
  INSTALL_COMMAND ""
  BINARY_DIR ${CMAKE_BINARY_DIR}/${proj}-build
  CMAKE_CACHE_ARGS ${ep_compiler}
    -DBUILD_TESTING:BOOL=OFF
    -DCMAKE_RUNTIME_OUTPUT_DIRECTORY:PATH=${inner}/${Slicer_CLIMODULES_BIN_DIR}
    -DCMAKE_LIBRARY_OUTPUT_DIRECTORY:PATH=${inner}/${Slicer_THIRDPARTY_LIB_DIR}
    -DCMAKE_INSTALL_BINDIR:STRING=${Slicer_INSTALL_THIRDPARTY_BIN_DIR}
    -DCMAKE_INSTALL_LIBDIR:STRING=${Slicer_INSTALL_THIRDPARTY_LIB_DIR}
    -DShapeton_INSTALL_TOOLS_DIR:STRING=${Slicer_INSTALL_CLIMODULES_BIN_DIR}
    -DITK_DIR:PATH=${ITK_DIR}
    -DVTK_DIR:PATH=${VTK_DIR}
    -DDCMTK_DIR:PATH=${DCMTK_DIR}
    -DOPENSSL_USE_STATIC_LIBS:BOOL=ON # the system's: Slicer gives its own to no extension
    -DBZIP2_INCLUDE_DIR:PATH=${ep_prefix}/include
    -DBZIP2_LIBRARY_RELEASE:FILEPATH=${ep_prefix}/lib/libbz2.a
    -DBoost_INCLUDE_DIR:PATH=${CMAKE_BINARY_DIR}/Boost
    -DEigen3_DIR:PATH=${Eigen3_DIR}
    -Dnlohmann_json_DIR:PATH=${nlohmann_json_DIR}
    -DSpectra_INCLUDE_DIR:PATH=${ep_prefix}/include
    -DMETIS_INCLUDE_DIR:PATH=${ep_prefix}/include
    -DMETIS_LIBRARY:FILEPATH=${ep_prefix}/lib/libmetis.a
    -DNAUTY_INCLUDE_DIR:PATH=${ep_prefix}/include
    -DNAUTY_LIBRARY:FILEPATH=${ep_prefix}/lib/libnauty.a
    -DSQLite3_INCLUDE_DIR:PATH=${ep_prefix}/include
    -DSQLite3_LIBRARY:FILEPATH=${ep_prefix}/lib/libsqlite3.a
    -DOpenCV_INCLUDE_DIR:PATH=${ep_prefix}/include/opencv4
    -DOpenCV_CORE_LIBRARY:FILEPATH=${opencv_lib}/libopencv_core.so
    -DOpenCV_IMGPROC_LIBRARY:FILEPATH=${opencv_lib}/libopencv_imgproc.so
  DEPENDS ${${proj}_DEPENDS})
set(Shapeton_DIR ${CMAKE_BINARY_DIR}/${proj}-build)
mark_as_superbuild(Shapeton_DIR:PATH)
