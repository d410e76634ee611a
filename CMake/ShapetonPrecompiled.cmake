# Precompiles the headers of ITK, Eigen, JSON and the standard library, which otherwise take half of the build time. Sources must still
# include all headers that they use: clang-tidy, header tests and builds of selected modules do not use precompiled headers.

# shapeton_precompile(<target>): makes a library, tool or test use the precompiled headers, if enabled in this build.
function(shapeton_precompile target)
  if(SHAPETON_MODULES OR CMAKE_CXX_CLANG_TIDY) # these may lack packages, or must see each source as it is
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

# Precompiled headers can be used only with the same compiler flags.
function(shapeton_precompiled_flags target)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_features(${target} PRIVATE cxx_std_17)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "EXECUTABLE")
    target_compile_options(${target} PRIVATE -fPIC) # after the -fPIE of CMake
  endif()
  if(ITK_VERSION_MAJOR LESS 6) # its headers use the precompiled Eigen
    get_property(eigen GLOBAL PROPERTY ShapetonPrecompiled_EIGEN)
    target_compile_definitions(${target} PRIVATE ITK_USE_SYSTEM_EIGEN)
    target_include_directories(${target} SYSTEM PRIVATE ${eigen})
  endif()
endfunction()
