# Code generated from the declarations of options, Modules/<Group>/<Module>/options/<Struct>.json; see options.py.
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
set(Shapeton_OPTIONS_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/options.py)

# shapeton_generate(<command> <source> <output>): runs options.py when CMake runs, and again when the source, a declaration or
# the script has changed.
function(shapeton_generate command source output)
  file(GLOB declarations CONFIGURE_DEPENDS ${Shapeton_SOURCE_DIR}/Modules/*/*/options/*.json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source} ${declarations} ${Shapeton_OPTIONS_SCRIPT})
  execute_process(COMMAND ${Python3_EXECUTABLE} ${Shapeton_OPTIONS_SCRIPT} ${command} ${source} ${output}
    RESULT_VARIABLE status)
  if(status)
    message(FATAL_ERROR "The options in ${source} are not valid, see above.")
  endif()
endfunction()

# shapeton_options(<library> <Struct>...): generates the headers of structs of options, called in src/CMakeLists.txt.
function(shapeton_options library)
  foreach(struct IN LISTS ARGN)
    shapeton_generate(header ${PROJECT_SOURCE_DIR}/options/${struct}.json ${PROJECT_BINARY_DIR}/include)
    set(headers ${PROJECT_BINARY_DIR}/include/shapeton${struct}.h ${PROJECT_BINARY_DIR}/include/shapeton${struct}Methods.h)
    if(DEFINED Shapeton_INSTALL_INCLUDE_DIR) # ITK installs this folder of each module
      install(FILES ${headers} DESTINATION ${Shapeton_INSTALL_INCLUDE_DIR} COMPONENT Development)
    endif()
  endforeach()
endfunction()
