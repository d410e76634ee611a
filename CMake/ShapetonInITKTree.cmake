# CMake functions that the modules use in addition to ITK's when they are built inside ITK. Shapeton_SOURCE_DIR and
# Shapeton_BINARY_DIR refer to the module Shapeton, the repository.
include(GoogleTest)
include(${Shapeton_SOURCE_DIR}/CMake/ShapetonITKTargets.cmake)
include(${Shapeton_SOURCE_DIR}/CMake/ShapetonKernels.cmake)
include(${Shapeton_SOURCE_DIR}/CMake/ShapetonOptions.cmake)
include(${Shapeton_SOURCE_DIR}/CMake/ShapetonPages.cmake)
include(${Shapeton_SOURCE_DIR}/CMake/ShapetonTests.cmake)
set(SHAPETON_TEST_DATA_DIR "$ENV{SHAPETON_TEST_DATA_DIR}" CACHE PATH
  "Folder of real data; tests that need it are skipped if this is empty")
file(MAKE_DIRECTORY ${Shapeton_BINARY_DIR}/Testing/Temporary)
# The program of the libraries, in the folder of ITK's libraries.
set(Shapeton_PROGRAM_FOLDER Shapeton-ITK-${ITK_VERSION_MAJOR}.${ITK_VERSION_MINOR})
set(CMAKE_INSTALL_LIBDIR ${ITK_INSTALL_LIBRARY_DIR})
# Precompiled headers, the GPU plug-in and its tests are part of the stand-alone build only.
function(shapeton_precompile)
endfunction()
function(shapeton_add_device_sources)
endfunction()
function(shapeton_device_tests)
endfunction()
