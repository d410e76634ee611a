# shapeton_write_needs(<file>): writes the targets of other packages that the users of each module link, so that
# find_package(Shapeton COMPONENTS ...) finds only these packages.
function(shapeton_write_needs file)
  set(text "# Targets of other packages that the users of each module link.\n")
  foreach(path IN LISTS Shapeton_MODULES)
    get_filename_component(module ${path} NAME)
    shapeton_needs_of(needs hidden ${module})
    set(needs_${module} ${needs})
    set(hidden_${module} ${hidden})
    if("${needs}" MATCHES "VTK::") # then all VTK targets exist, and the linked ones need their dependencies
      list(APPEND needs ${hidden})
      list(REMOVE_DUPLICATES needs)
    endif()
    string(APPEND text "set(Shapeton_${module}_NEEDS ${needs})\n")
    list(APPEND modules ${module})
  endforeach()
  file(WRITE ${file} "${text}set(Shapeton_MODULES ${modules})\n")
endfunction()

# Finds the targets of other packages that users of a module link, and the VTK targets hidden by shared libraries. Reads needs_<module> and
# hidden_<module> of the earlier modules.
function(shapeton_needs_of needs_variable hidden_variable module)
  get_target_property(public Shapeton${module} INTERFACE_LINK_LIBRARIES)
  get_target_property(type Shapeton${module} TYPE)
  set(private "")
  set(hidden "")
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    get_target_property(private Shapeton${module} LINK_LIBRARIES)
    set(hidden ${private})
    list(FILTER hidden INCLUDE REGEX "^VTK::")
    list(FILTER private INCLUDE REGEX "^Shapeton::") # CMake also follows the link dependencies of our shared libraries
  endif()
  set(needs "")
  foreach(library IN LISTS public private)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" library "${library}") # private dependency of a static library
    if(library MATCHES "^Shapeton::(.*)$")
      list(APPEND needs ${needs_${CMAKE_MATCH_1}})
      list(APPEND hidden ${hidden_${CMAKE_MATCH_1}})
    elseif(library MATCHES "^gdcm")
      list(APPEND needs GDCM::${library}) # GDCM's targets have no namespace
    elseif(library MATCHES "^[A-Za-z0-9_]+::")
      list(APPEND needs ${library})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES needs)
  list(REMOVE_DUPLICATES hidden)
  set(${needs_variable} ${needs} PARENT_SCOPE)
  set(${hidden_variable} ${hidden} PARENT_SCOPE)
endfunction()
