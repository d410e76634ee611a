# shapeton_add_tool(<Name> MODULES a b ...)
# Builds bin/<Name> from <Name>.cxx and <Name>.xml, with the XML embedded (--xml prints it) and next to it (read by 3D Slicer).
function(shapeton_add_tool name)
  cmake_parse_arguments(PARSE_ARGV 1 tool "" "" "MODULES;LIBRARIES")
  set(xml ${CMAKE_CURRENT_BINARY_DIR}/${name}.xml)
  shapeton_generate(xml ${CMAKE_CURRENT_SOURCE_DIR}/${name}.xml ${xml})
  file(READ ${xml} text)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}XML.h @ONLY
    CONTENT "// Generated from @name@.xml\nstatic const char ToolXML[] = R\"__XML__(@text@)__XML__\";\n")
  configure_file(${xml} ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name}.xml COPYONLY)
  add_executable(${name} ${name}.cxx)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
  shapeton_link_modules(${name} PRIVATE CommandLine ${tool_MODULES})
  target_link_libraries(${name} PRIVATE ${tool_LIBRARIES})
  shapeton_precompile(${name})
  # The libraries are two folders above the tools, or one above in a 3D Slicer extension.
  set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN/../..;$ORIGIN/..")
  install(TARGETS ${name} RUNTIME DESTINATION ${Shapeton_INSTALL_TOOLS_DIR} COMPONENT Tools)
  install(FILES ${xml} DESTINATION ${Shapeton_INSTALL_TOOLS_DIR} COMPONENT Tools)
  shapeton_install_command(${name})
  set_property(GLOBAL APPEND PROPERTY SHAPETON_TOOL_DESCRIPTIONS ${xml})
  if(BUILD_TESTING)
    add_test(NAME ${name}XML COMMAND ${CMAKE_COMMAND} -DTOOL=$<TARGET_FILE:${name}> -DXML=${xml}
      -P ${Shapeton_SOURCE_DIR}/CMake/CheckToolXML.cmake)
    add_test(NAME ${name}XMLLint COMMAND ${Shapeton_SOURCE_DIR}/Testing/Rules/check-rules ${xml})
    set_tests_properties(${name}XML ${name}XMLLint PROPERTIES LABELS Applications)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/Testing/CMakeLists.txt)
      add_subdirectory(Testing)
    endif()
  endif()
endfunction()

# Creates a link to the tool in bin; the link is relative, and its target need not exist yet.
function(shapeton_install_command name)
  file(RELATIVE_PATH tool /${CMAKE_INSTALL_BINDIR} /${Shapeton_INSTALL_TOOLS_DIR}/${name})
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/commands)
  file(CREATE_LINK ${tool} ${CMAKE_BINARY_DIR}/commands/${name} SYMBOLIC)
  install(PROGRAMS ${CMAKE_BINARY_DIR}/commands/${name} DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT Tools)
endfunction()

# Makes and installs a manual page and completions for bash, zsh and fish, for each tool added before.
function(shapeton_add_manuals)
  get_property(descriptions GLOBAL PROPERTY SHAPETON_TOOL_DESCRIPTIONS)
  set(script ${Shapeton_SOURCE_DIR}/CMake/manuals.py)
  set(folder ${CMAKE_BINARY_DIR}/manuals)
  add_custom_command(OUTPUT ${folder}.stamp
    COMMAND ${Python3_EXECUTABLE} ${script} ${folder} ${Shapeton_DATE} ${descriptions}
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}.stamp
    DEPENDS ${script} ${descriptions} COMMENT "Writing manual pages and completions" VERBATIM)
  add_custom_target(Manuals ALL DEPENDS ${folder}.stamp)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_DATAROOTDIR} COMPONENT Tools)
endfunction()

# shapeton_tool_test(NAME <name> [STATUS <exit status>] [STDOUT <regex>] [STDERR <regex>] [DATA] [LONG] COMMAND <tool> <arguments...>)
# Runs a tool. The exit status must equal STATUS (default 0); stderr must be empty for 0 and one line otherwise.
# DATA: the test reads SHAPETON_TEST_DATA_DIR and is skipped if that is not set.
# LONG: Utilities/run-tests runs the test only with --long.
function(shapeton_tool_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "DATA;LONG" "NAME;STATUS;STDOUT;STDERR" "COMMAND")
  if(NOT test_STATUS)
    set(test_STATUS 0)
  endif()
  list(POP_FRONT test_COMMAND tool)
  add_test(NAME ${test_NAME} COMMAND ${CMAKE_COMMAND} -DTOOL=$<TARGET_FILE:${tool}> "-DARGUMENTS=${test_COMMAND}"
    -DSTATUS=${test_STATUS} "-DSTDOUT=${test_STDOUT}" "-DSTDERR=${test_STDERR}" -DNEEDS_DATA=${test_DATA}
    "-DDATA_DIR=${SHAPETON_TEST_DATA_DIR}"
    -P ${Shapeton_SOURCE_DIR}/CMake/RunTool.cmake)
  set(labels Applications)
  if(test_LONG)
    list(APPEND labels Long)
  endif()
  set_tests_properties(${test_NAME} PROPERTIES LABELS "${labels}" SKIP_REGULAR_EXPRESSION "SHAPETON_TEST_DATA_DIR is not set")
endfunction()
