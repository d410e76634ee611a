# GPU kernels. Modules register their .cu files, which are built into one plug-in, loaded at run time if present; libraries and
# tools do not depend on CUDA. The same files, compiled as C++, form the stand-in that the tests compare with the CPU.
set(SHAPETON_USE_CUDA AUTO CACHE STRING "Build the plug-in for NVIDIA GPUs: AUTO (if the CUDA toolkit is found), ON or OFF")
set_property(CACHE SHAPETON_USE_CUDA PROPERTY STRINGS AUTO ON OFF)

# shapeton_add_device_sources(<file.cu>... [FLUSH_TO_ZERO]): called in src/CMakeLists.txt of a module. FLUSH_TO_ZERO: subnormal
# float results are flushed to 0, as in FlushToZero.
function(shapeton_add_device_sources)
  cmake_parse_arguments(PARSE_ARGV 0 device "FLUSH_TO_ZERO" "" "")
  foreach(source IN LISTS device_UNPARSED_ARGUMENTS)
    get_filename_component(path ${source} ABSOLUTE)
    set_property(GLOBAL APPEND PROPERTY Shapeton_DEVICE_SOURCES ${path})
    set_property(GLOBAL PROPERTY Shapeton_DEVICE_FLUSH_${path} ${device_FLUSH_TO_ZERO})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY Shapeton_DEVICE_INCLUDES
    ${CMAKE_CURRENT_SOURCE_DIR} $<TARGET_PROPERTY:${itk-module},INCLUDE_DIRECTORIES>)
endfunction()

# Searches for the toolkit in the usual places: PATH, CUDACXX, CUDAToolkit_ROOT, /usr/local/cuda, Debian's package.
function(shapeton_find_cuda found)
  set(${found} OFF PARENT_SCOPE)
  if(SHAPETON_USE_CUDA STREQUAL "OFF")
    return()
  endif()
  find_package(CUDAToolkit QUIET)
  if(CUDAToolkit_FOUND AND NOT DEFINED ENV{CUDACXX})
    set(ENV{CUDACXX} ${CUDAToolkit_NVCC_EXECUTABLE})
  endif()
  if(NOT CMAKE_CUDA_COMPILER) # the compiler may have been installed since the last configuration
    unset(CMAKE_CUDA_COMPILER CACHE)
  endif()
  include(CheckLanguage)
  check_language(CUDA)
  if(CMAKE_CUDA_COMPILER)
    set(${found} ON PARENT_SCOPE)
  elseif(NOT SHAPETON_USE_CUDA STREQUAL "AUTO")
    message(FATAL_ERROR "SHAPETON_USE_CUDA=ON, but no working CUDA compiler was found: install the CUDA toolkit, or set CUDAToolkit_ROOT")
  endif()
endfunction()

# The compute capabilities from 7.0 to 9.0 that this toolkit supports, and PTX for future GPUs.
function(shapeton_cuda_architectures list)
  execute_process(COMMAND ${CMAKE_CUDA_COMPILER} --list-gpu-arch OUTPUT_VARIABLE known)
  set(architectures "")
  foreach(capability 70 75 80 86 89 90)
    if("${known}" MATCHES "compute_${capability}([^0-9]|$)")
      list(APPEND architectures ${capability}-real)
      set(newest ${capability})
    endif()
  endforeach()
  set(${list} ${architectures} ${newest}-virtual PARENT_SCOPE)
endfunction()

# Settings of both plug-ins: the version, and no fusing of a*b+c.
function(shapeton_device_library target)
  get_property(includes GLOBAL PROPERTY Shapeton_DEVICE_INCLUDES)
  target_include_directories(${target} PRIVATE ${includes})
  target_compile_features(${target} PRIVATE cxx_std_17)
  target_compile_definitions(${target} PRIVATE SHAPETON_DEVICE_VERSION="${Shapeton_VERSION}" ITK_STATIC)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden CUDA_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)
endfunction()

function(shapeton_add_cuda_plugin)
  get_property(sources GLOBAL PROPERTY Shapeton_DEVICE_SOURCES)
  add_library(ShapetonCuda MODULE ${sources})
  shapeton_device_library(ShapetonCuda)
  foreach(source IN LISTS sources)
    get_property(flush GLOBAL PROPERTY Shapeton_DEVICE_FLUSH_${source})
    set_source_files_properties(${source} PROPERTIES LANGUAGE CUDA)
    if(flush)
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS --ftz=true)
    endif()
  endforeach()
  target_compile_options(ShapetonCuda PRIVATE $<$<COMPILE_LANGUAGE:CUDA>:--fmad=false>
    $<$<COMPILE_LANGUAGE:CUDA>:--prec-div=true> $<$<COMPILE_LANGUAGE:CUDA>:--prec-sqrt=true>
    $<$<COMPILE_LANGUAGE:CUDA>:--expt-relaxed-constexpr> $<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-ffp-contract=off>)
  set_target_properties(ShapetonCuda PROPERTIES OUTPUT_NAME ShapetonCuda-${Shapeton_SERIES}
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${Shapeton_PROGRAM_FOLDER}
    CUDA_RUNTIME_LIBRARY Static CUDA_STANDARD 17)
  install(TARGETS ShapetonCuda LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/${Shapeton_PROGRAM_FOLDER} COMPONENT Cuda)
endfunction()

# Each .cu file is included by a wrapper with a C++ extension.
function(shapeton_add_device_stand_in)
  get_property(sources GLOBAL PROPERTY Shapeton_DEVICE_SOURCES)
  set(wrappers "")
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    set(wrapper ${CMAKE_BINARY_DIR}/DeviceStandIn/${name}.cxx)
    file(CONFIGURE OUTPUT ${wrapper} CONTENT "#include \"${source}\"\n")
    get_property(flush GLOBAL PROPERTY Shapeton_DEVICE_FLUSH_${source})
    if(flush)
      set_property(SOURCE ${wrapper} APPEND PROPERTY COMPILE_DEFINITIONS SHAPETON_FLUSH_TO_ZERO)
    endif()
    list(APPEND wrappers ${wrapper})
  endforeach()
  add_library(DeviceStandIn MODULE ${wrappers})
  set_target_properties(DeviceStandIn PROPERTIES UNITY_BUILD OFF) # compile each file on its own, as nvcc does
  shapeton_device_library(DeviceStandIn)
endfunction()

set(SHAPETON_CUDA OFF)
if(NOT SHAPETON_SANITIZE AND NOT SHAPETON_PYTHON_ONLY AND NOT SHAPETON_MODULES) # selected modules are for static libraries
  shapeton_find_cuda(SHAPETON_CUDA)
endif()
if(SHAPETON_CUDA)
  if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    shapeton_cuda_architectures(architectures)
    set(CMAKE_CUDA_ARCHITECTURES ${architectures} CACHE STRING "Architectures of the plug-in for NVIDIA GPUs")
  endif()
  enable_language(CUDA)
  message(STATUS "GPU plug-in: CUDA ${CMAKE_CUDA_COMPILER_VERSION}, architectures ${CMAKE_CUDA_ARCHITECTURES}")
else()
  message(STATUS "GPU plug-in: none (no CUDA toolkit, or SHAPETON_USE_CUDA=OFF)")
endif()

# Called after all modules.
function(shapeton_add_device_plugins)
  if(SHAPETON_CUDA)
    shapeton_add_cuda_plugin()
  endif()
  if(BUILD_TESTING)
    shapeton_add_device_stand_in()
  endif()
endfunction()
