# shapeton_join_scripts(NAME FILES file... [START statement])
#
# Joins the scripts or styles of a page, in dependency order, into shapetonNAME.cxx in the current binary directory, which defines
# shapeton::NAME, the text pieces for PageText(). See ShapetonScripts.cmake.
function(shapeton_join_scripts name)
  cmake_parse_arguments(JOIN "" "START" "FILES" ${ARGN})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/shapeton${name}.cxx)
  set(join ${Shapeton_SOURCE_DIR}/CMake/ShapetonScripts.cmake)
  list(TRANSFORM JOIN_FILES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")
  add_custom_command(OUTPUT ${out} VERBATIM DEPENDS ${JOIN_FILES} ${join}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DNAME=${name} "-DSTART=${JOIN_START}" "-DFILES=${JOIN_FILES}" -P ${join})
endfunction()

# Shared page scripts; they precede a page's own scripts.
set(SHAPETON_PAGE_KIT_SCRIPTS math bytes view page keys gl)
list(TRANSFORM SHAPETON_PAGE_KIT_SCRIPTS REPLACE "(.+)" "${Shapeton_SOURCE_DIR}/Modules/Core/Pages/scripts/\\1.mjs")
set(SHAPETON_PAGE_KIT_STYLE "${Shapeton_SOURCE_DIR}/Modules/Core/Pages/scripts/page.css")

find_program(NODE_EXECUTABLE node)
find_program(CHROMIUM_EXECUTABLE chromium)

# shapeton_script_test(NAME name SCRIPT file LABELS label...): tests scripts that do not need a page; skipped without node.
function(shapeton_script_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;SCRIPT" "LABELS")
  set(command ${CMAKE_COMMAND} -E echo "node is not installed")
  if(NODE_EXECUTABLE)
    set(command ${NODE_EXECUTABLE} --test ${CMAKE_CURRENT_SOURCE_DIR}/${test_SCRIPT})
  endif()
  add_test(NAME ${test_NAME} COMMAND ${command})
  set_tests_properties(${test_NAME} PROPERTIES LABELS "${test_LABELS}" SKIP_REGULAR_EXPRESSION "node is not installed")
endfunction()

# shapeton_browser_test(NAME name SCRIPT file [ENVIRONMENT NAME=value...] [FIXTURES fixture...] [LABELS label...]): runs a node script
# that operates pages in a browser like a user (Testing/Browser/browser.mjs); skipped without node and chromium.
function(shapeton_browser_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;SCRIPT" "ENVIRONMENT;FIXTURES;LABELS")
  set(command ${CMAKE_COMMAND} -E echo "node and chromium are not installed")
  if(NODE_EXECUTABLE AND CHROMIUM_EXECUTABLE)
    set(command ${NODE_EXECUTABLE} --test ${CMAKE_CURRENT_SOURCE_DIR}/${test_SCRIPT})
  endif()
  add_test(NAME ${test_NAME} COMMAND ${command})
  set_tests_properties(${test_NAME} PROPERTIES LABELS "Applications;${test_LABELS}" TIMEOUT 600 RUN_SERIAL ON
    FIXTURES_REQUIRED "${test_FIXTURES}" ENVIRONMENT "CHROMIUM=${CHROMIUM_EXECUTABLE};${test_ENVIRONMENT}"
    SKIP_REGULAR_EXPRESSION "node and chromium are not installed")
endfunction()
