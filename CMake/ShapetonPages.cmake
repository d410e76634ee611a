# shapeton_join_scripts(NAME FILES file... [START statement])
#
# Joins scripts or styles of a page, in the order of their dependencies, into shapetonNAME.cxx in the current binary directory,
# which defines shapeton::NAME, pieces of text for PageText(). How: ShapetonScripts.cmake.
function(shapeton_join_scripts name)
  cmake_parse_arguments(JOIN "" "START" "FILES" ${ARGN})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/shapeton${name}.cxx)
  set(join ${Shapeton_SOURCE_DIR}/CMake/ShapetonScripts.cmake)
  list(TRANSFORM JOIN_FILES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")
  add_custom_command(OUTPUT ${out} VERBATIM DEPENDS ${JOIN_FILES} ${join}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DNAME=${name} "-DSTART=${JOIN_START}" "-DFILES=${JOIN_FILES}" -P ${join})
endfunction()

# Scripts that pages share, before their own.
set(SHAPETON_PAGE_KIT_SCRIPTS math bytes view)
list(TRANSFORM SHAPETON_PAGE_KIT_SCRIPTS REPLACE "(.+)" "${Shapeton_SOURCE_DIR}/Modules/Visualization/PageKit/scripts/\\1.mjs")
