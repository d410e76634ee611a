# Core and imgproc only, as shared libraries in the extension package: static libraries require further libraries.
set(proj OpenCV)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
set(inner ${CMAKE_BINARY_DIR}/${EXTENSION_BUILD_SUBDIRECTORY})
set(off "")
foreach(feature 1394 ADE EIGEN FFMPEG FLATBUFFERS GSTREAMER GTK IPP ITT JASPER JPEG LAPACK OPENCL OPENEXR OPENJPEG PNG
    PROTOBUF QUIRC TIFF V4L VA VTK WEBP)
  list(APPEND off -DWITH_${feature}:BOOL=OFF)
endforeach()
simple_project(${proj} VERSION 4.10.0 GIT https://github.com/opencv/opencv.git CACHE
  ${off}
  -DBUILD_LIST:STRING=core,imgproc
  -DBUILD_SHARED_LIBS:BOOL=ON
  -DBUILD_ZLIB:BOOL=ON
  -DBUILD_PERF_TESTS:BOOL=OFF
  -DBUILD_TESTS:BOOL=OFF
  -DBUILD_opencv_apps:BOOL=OFF
  -DBUILD_JAVA:BOOL=OFF
  -DOPENCV_LIB_INSTALL_PATH:STRING=${Slicer_INSTALL_THIRDPARTY_LIB_DIR}
  -DLIBRARY_OUTPUT_PATH:PATH=${inner}/${Slicer_THIRDPARTY_LIB_DIR})
set(OpenCV_DIR ${CMAKE_BINARY_DIR}/${proj}-build)
mark_as_superbuild(OpenCV_DIR:PATH)
