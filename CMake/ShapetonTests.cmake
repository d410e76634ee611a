# Functions called by test/CMakeLists.txt of a module, in the stand-alone build and inside an ITK source tree.

# creategoogletestdriver(<kit> "<libraries>" "<sources>" [ALONE <source>...] [TOGETHER] [LONG <Suite.Test>...]):
# builds the executable <kit>GTestDriver; each TEST is a ctest. Sources after ALONE, whose names clash with others, are excluded
# from the unity build. Tests after LONG have the label Long: Utilities/run-tests runs them with --long. TOGETHER: all tests are one
# ctest, and those after LONG another one, because they share expensive data that is computed once per process.
function(creategoogletestdriver kit libraries sources)
  cmake_parse_arguments(PARSE_ARGV 3 driver "TOGETHER" "" "ALONE;LONG")
  add_executable(${kit}GTestDriver ${sources})
  target_link_libraries(${kit}GTestDriver PRIVATE ${libraries} GTest::gtest_main)
  target_include_directories(${kit}GTestDriver PRIVATE ${Shapeton_SOURCE_DIR}/Modules/Core/Common/test)
  # The tested code is in the libraries. Most of the time of a test is its compilation, which -O3 makes a fifth longer.
  target_compile_options(${kit}GTestDriver PRIVATE $<$<CONFIG:Release>:-O1>)
  shapeton_precompile(${kit}GTestDriver)
  set_source_files_properties(${driver_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_compile_definitions(${kit}GTestDriver PRIVATE
    SHAPETON_BASELINE_DIR="${Shapeton_SOURCE_DIR}/Testing/Baseline"
    SHAPETON_TEST_TEMPORARY_DIR="${Shapeton_BINARY_DIR}/Testing/Temporary")
  list(JOIN driver_LONG ":" long)
  if(driver_TOGETHER)
    shapeton_add_together(${kit} ${kit} "-${long}" ${itk-module})
    if(long)
      shapeton_add_together(${kit}Long ${kit} "${long}" Long)
    endif()
    return()
  endif()
  shapeton_discover_tests(${kit} "-${long}" ${itk-module})
  if(long)
    shapeton_discover_tests(${kit} "${long}" Long)
  endif()
endfunction()

# shapeton_device_tests(<kit> "<libraries>" "<sources>" [<include folders>...]): builds a driver whose tests compare a GPU with the
# CPU. They run with the stand-in, as StandIn.<Suite.Test>, and with the plug-in, as Gpu.<Suite.Test>, which is skipped without a
# GPU.
function(shapeton_device_tests kit libraries sources)
  add_executable(${kit}GTestDriver ${sources})
  target_link_libraries(${kit}GTestDriver PRIVATE ${libraries} Shapeton::Common GTest::gtest_main)
  target_include_directories(${kit}GTestDriver PRIVATE ${Shapeton_SOURCE_DIR}/Modules/Core/Common/test ${ARGN})
  target_compile_options(${kit}GTestDriver PRIVATE $<$<CONFIG:Release>:-O1>)
  foreach(device StandIn Gpu)
    set(environment "")
    if(device STREQUAL "StandIn")
      set(environment ENVIRONMENT "SHAPETON_DEVICE_PLUGIN=$<TARGET_FILE:DeviceStandIn>")
    endif()
    gtest_discover_tests(${kit}GTestDriver DISCOVERY_TIMEOUT 120 TEST_PREFIX ${device}. TEST_LIST ${kit}${device}
      PROPERTIES LABELS ${itk-module} SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]" ${environment})
  endforeach()
  add_dependencies(${kit}GTestDriver DeviceStandIn)
endfunction()

# shapeton_compare_devices(<tool> <arguments>...): runs the tool on the CPU and on the stand-in, as <tool>Devices, or on a GPU, as
# <tool>Gpu; {OUT} in the arguments is the output folder of each run. All files except the run records must be identical. Without
# a GPU, --device cuda must fail with one line.
function(shapeton_compare_devices tool)
  foreach(test Devices Gpu)
    set(plugin "")
    if(test STREQUAL "Devices")
      set(plugin $<TARGET_FILE:DeviceStandIn>)
    endif()
    add_test(NAME ${tool}${test} COMMAND ${CMAKE_COMMAND} -DTOOL=$<TARGET_FILE:${tool}> -DPLUGIN=${plugin}
      -DOUT=${CMAKE_CURRENT_BINARY_DIR}/${test} "-DARGUMENTS=${ARGN}" -P ${Shapeton_SOURCE_DIR}/CMake/CompareDevices.cmake)
  endforeach()
  set_tests_properties(${tool}Devices ${tool}Gpu PROPERTIES LABELS Applications SKIP_REGULAR_EXPRESSION "no usable GPU")
endfunction()

# Adds one ctest for all tests of a driver that match a GoogleTest filter.
function(shapeton_add_together name kit filter label)
  add_test(NAME ${name} COMMAND ${kit}GTestDriver --gtest_filter=${filter})
  set_tests_properties(${name} PROPERTIES LABELS ${label})
endfunction()

# Adds one ctest for each test of a driver that matches a GoogleTest filter.
function(shapeton_discover_tests kit filter label)
  string(MD5 list "${filter}")
  gtest_discover_tests(${kit}GTestDriver DISCOVERY_TIMEOUT 120 TEST_FILTER "${filter}" TEST_LIST ${kit}${list}
    PROPERTIES LABELS ${label} SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]"
      ENVIRONMENT "SHAPETON_TEST_DATA_DIR=${SHAPETON_TEST_DATA_DIR}")
endfunction()

# shapeton_compare_test(NAME <name> DEPENDS <test that writes it> OUTPUT <file> BASELINE <file> [TOLERANCE <t>] [PIXELS <n>])
# Compares an image with its baseline using itkTestDriver: at most PIXELS pixels (default 0) may differ by more than TOLERANCE.
function(shapeton_compare_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;OUTPUT;BASELINE;TOLERANCE;PIXELS;DEPENDS" "")
  if(NOT test_TOLERANCE)
    set(test_TOLERANCE 1e-5)
  endif()
  if(NOT test_PIXELS)
    set(test_PIXELS 0)
  endif()
  add_test(NAME ${test_NAME} COMMAND itkTestDriver --compare ${test_OUTPUT} ${test_BASELINE}
    --compareIntensityTolerance ${test_TOLERANCE} --compareNumberOfPixelsTolerance ${test_PIXELS} --no-process)
  set_tests_properties(${test_NAME} PROPERTIES LABELS Applications DEPENDS "${test_DEPENDS}")
endfunction()
