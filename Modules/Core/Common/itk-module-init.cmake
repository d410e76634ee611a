# ITK's build reads this file before the first Shapeton module, which is this one.
include(${Shapeton_SOURCE_DIR}/CMake/ShapetonInITKTree.cmake)
