# ITK's build reads this file before its first module of ours, which is this one.
include(${Shapeton_SOURCE_DIR}/CMake/ShapetonInITKTree.cmake)
