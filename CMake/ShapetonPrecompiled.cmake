# Half of the time of a build were the headers of ITK, Eigen, JSON and the standard library: they are compiled once. A source
# still includes what it uses: clang-tidy, the tests of public headers and builds of selected modules have no such help.

# shapeton_precompile(<target>): lets a library, tool or test take the precompiled headers, where this build has them.
function(shapeton_precompile target)
  if(SHAPETON_MODULES OR CMAKE_CXX_CLANG_TIDY) # these need not have all the packages, or are to see each source as it is
    return()
  endif()
  if(NOT TARGET ShapetonPrecompiled)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/CMakeFiles/ShapetonPrecompiled.cxx CONTENT "\n")
    add_library(ShapetonPrecompiled OBJECT ${CMAKE_BINARY_DIR}/CMakeFiles/ShapetonPrecompiled.cxx)
    shapeton_precompiled_flags(ShapetonPrecompiled)
    find_package(nlohmann_json REQUIRED)
    shapeton_link_modules(ShapetonPrecompiled PRIVATE ITKCommon)
    shapeton_link_eigen(ShapetonPrecompiled PRIVATE)
    get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
    set_property(GLOBAL PROPERTY ShapetonPrecompiled_EIGEN ${eigen})
    target_link_libraries(ShapetonPrecompiled PRIVATE nlohmann_json::nlohmann_json)
    target_precompile_headers(ShapetonPrecompiled PRIVATE <algorithm> <array> <atomic> <charconv> <cmath> <complex> <cstdint>
      <deque> <filesystem> <fstream> <functional> <future> <iostream> <limits> <map> <memory> <mutex> <numeric> <optional> <queue>
      <set> <sstream> <stdexcept> <string> <thread> <unordered_map> <utility> <vector> <Eigen/Dense> <Eigen/SparseCore>
      <nlohmann/json.hpp> <itkImage.h> <itkImageRegionConstIterator.h> <itkImageRegionIterator.h> <itkMultiThreaderBase.h>)
  endif()
  shapeton_precompiled_flags(${target})
  target_precompile_headers(${target} REUSE_FROM ShapetonPrecompiled)
endfunction()

# Precompiled headers serve those that are compiled by the same flags.
function(shapeton_precompiled_flags target)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_features(${target} PRIVATE cxx_std_17)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "EXECUTABLE")
    target_compile_options(${target} PRIVATE -fPIC) # after the -fPIE of CMake
  endif()
  if(ITK_VERSION_MAJOR LESS 6) # its headers take the Eigen that is precompiled
    get_property(eigen GLOBAL PROPERTY ShapetonPrecompiled_EIGEN)
    target_compile_definitions(${target} PRIVATE ITK_USE_SYSTEM_EIGEN)
    target_include_directories(${target} SYSTEM PRIVATE ${eigen})
  endif()
endfunction()
