# What test/CMakeLists.txt of a module calls, in our build and inside an ITK source tree.

# creategoogletestdriver(<kit> "<libraries>" "<sources>" [ALONE <source>...] [TOGETHER] [LONG <Suite.Test>...]):
# one executable <kit>GTestDriver; sources after ALONE, which have names of others, are compiled alone in a unity build;
# each TEST is a ctest. Those after LONG have the label Long: Utilities/run-tests runs them with --long. TOGETHER: all are one
# ctest, and those after LONG another one, because they share what takes long to make, which a process can make once.
function(creategoogletestdriver kit libraries sources)
  cmake_parse_arguments(PARSE_ARGV 3 driver "TOGETHER" "" "ALONE;LONG")
  add_executable(${kit}GTestDriver ${sources})
  target_link_libraries(${kit}GTestDriver PRIVATE ${libraries} GTest::gtest_main)
  # What is tested is in the libraries; of the time of a test most is its compilation, and -O3 makes it a fifth longer.
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

# shapeton_device_tests(<kit> "<libraries>" "<sources>" [<include folders>...]): a driver whose tests compare a GPU with the CPU.
# They run with the stand-in, as StandIn.<Suite.Test>, and with the plug-in, as Gpu.<Suite.Test>, which is skipped where there is
# no GPU.
function(shapeton_device_tests kit libraries sources)
  add_executable(${kit}GTestDriver ${sources})
  target_link_libraries(${kit}GTestDriver PRIVATE ${libraries} Shapeton::Devices GTest::gtest_main)
  target_include_directories(${kit}GTestDriver PRIVATE ${Shapeton_SOURCE_DIR}/Modules/Core/Devices/test ${ARGN})
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
# <tool>Gpu, with {OUT} in the arguments for a folder of each; all files but the run records must be the same bytes. Where there is
# no GPU, --device cuda must fail by one line.
function(shapeton_compare_devices tool)
  shapeton_tool_target(target ${tool})
  foreach(test Devices Gpu)
    set(plugin "")
    if(test STREQUAL "Devices")
      set(plugin $<TARGET_FILE:DeviceStandIn>)
    endif()
    add_test(NAME ${tool}${test} COMMAND ${CMAKE_COMMAND} -DTOOL=$<TARGET_FILE:${target}> -DPLUGIN=${plugin}
      -DOUT=${CMAKE_CURRENT_BINARY_DIR}/${test} "-DARGUMENTS=${ARGN}" -P ${Shapeton_SOURCE_DIR}/CMake/CompareDevices.cmake)
  endforeach()
  set_tests_properties(${tool}Devices ${tool}Gpu PROPERTIES LABELS Applications SKIP_REGULAR_EXPRESSION "there is no GPU")
endfunction()

# One ctest of the tests of a driver that a filter of GoogleTest lets through.
function(shapeton_add_together name kit filter label)
  add_test(NAME ${name} COMMAND ${kit}GTestDriver --gtest_filter=${filter})
  set_tests_properties(${name} PROPERTIES LABELS ${label})
endfunction()

# The tests of a driver that a filter of GoogleTest lets through.
function(shapeton_discover_tests kit filter label)
  string(MD5 list "${filter}")
  gtest_discover_tests(${kit}GTestDriver DISCOVERY_TIMEOUT 120 TEST_FILTER "${filter}" TEST_LIST ${kit}${list}
    PROPERTIES LABELS ${label} SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]"
      ENVIRONMENT "SHAPETON_TEST_DATA_DIR=${SHAPETON_TEST_DATA_DIR}")
endfunction()

# shapeton_compare_test(NAME <name> DEPENDS <test that writes it> OUTPUT <file> BASELINE <file> [TOLERANCE <t>] [PIXELS <n>])
# Compares an image with its baseline by itkTestDriver: at most PIXELS pixels (default 0) may differ by more than TOLERANCE.
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
