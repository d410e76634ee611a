# shapeton_add_kernels(<name> <source> [<sources compiled once>...]): compiles a kernel source once per instruction set, see
# shapetonInstructionSets.h, and the other sources with the same options for the baseline only. A library, or a test of
# unexported code, links them with target_link_libraries(<target> PRIVATE $<BUILD_INTERFACE:<name>>).
function(shapeton_add_kernels name source)
  set(sets Baseline)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND sets Avx2 Avx512)
  endif()
  set(bytes_Baseline 16)
  set(bytes_Avx2 32)
  set(bytes_Avx512 64)
  set(option_Avx2 -mavx2)
  # GCC warns that undefined operands of its own AVX-512 intrinsics are uninitialized.
  set(option_Avx512 -mavx512f $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_library(${name} INTERFACE)
  foreach(set IN LISTS sets)
    set(sources ${source})
    if(set STREQUAL Baseline)
      list(APPEND sources ${ARGN})
    endif()
    add_library(${name}${set} OBJECT ${sources})
    set_target_properties(${name}${set} PROPERTIES
      UNITY_BUILD OFF POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_compile_features(${name}${set} PRIVATE cxx_std_17)
    target_compile_definitions(${name}${set} PRIVATE
      SHAPETON_INSTRUCTION_SET=${set} SHAPETON_VECTOR_BYTES=${bytes_${set}})
    # No fusing of a*b+c, for equal results on every CPU. Vectorize regardless of the build type.
    target_compile_options(${name}${set} PRIVATE
      -ffp-contract=off -fno-math-errno -Wno-psabi $<$<NOT:$<CONFIG:Debug>>:-O3> ${option_${set}})
    target_include_directories(${name}${set} PRIVATE
      ${CMAKE_CURRENT_SOURCE_DIR} $<TARGET_PROPERTY:${itk-module},INCLUDE_DIRECTORIES>)
    target_sources(${name} INTERFACE $<TARGET_OBJECTS:${name}${set}>)
  endforeach()
endfunction()
