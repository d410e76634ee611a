# A stub of the CMake package of 3D Slicer, for tests without it: the folders provided by Slicer for extensions, and
# the functions for dependencies of a source tree of Slicer (Slicer_SOURCE_TREE).
set(Slicer_USE_FILE ${CMAKE_CURRENT_LIST_DIR}/UseSlicer.cmake)
set(Slicer_EXTENSION_GENERATE_CONFIG ${CMAKE_CURRENT_LIST_DIR}/GenerateConfig.cmake)
set(Slicer_EXTENSION_CPACK ${CMAKE_CURRENT_LIST_DIR}/ExtensionCPack.cmake)
set(lib lib/Slicer-5.9)
foreach(install "" INSTALL_)
  set(Slicer_${install}THIRDPARTY_BIN_DIR bin)
  set(Slicer_${install}THIRDPARTY_LIB_DIR ${lib})
  set(Slicer_${install}CLIMODULES_BIN_DIR ${lib}/cli-modules)
  set(Slicer_${install}QTSCRIPTEDMODULES_LIB_DIR ${lib}/qt-scripted-modules)
endforeach()
