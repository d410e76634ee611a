# Checks that components find only the required packages, and that an unknown name is an error with a clear message, both
# for components and for SHAPETON_MODULES.
include(${CMAKE_CURRENT_LIST_DIR}/Consumers.cmake)
set(source ${SOURCE_DIR}/Testing/Consumer/Component)

# find(<folder> <modules> <arguments...>): configures and sets `status` and `errors`.
function(find folder modules)
  file(REMOVE_RECURSE "${WORK_DIR}/${folder}")
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B "${WORK_DIR}/${folder}" -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
    "-DCMAKE_PREFIX_PATH=${PREFIX}" -DVERSION=${VERSION} -DMODULES=${modules}
    -DSOURCE=${SOURCE_DIR}/Examples/Heat.cxx ${ARGN}
    OUTPUT_QUIET ERROR_VARIABLE errors RESULT_VARIABLE status)
  set(status ${status} PARENT_SCOPE)
  set(errors "${errors}" PARENT_SCOPE)
endfunction()

set(absent -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON -DCMAKE_DISABLE_FIND_PACKAGE_OpenSSL=ON)
find(needed Heat ${absent})
if(NOT status EQUAL 0)
  message(FATAL_ERROR "Heat must not require any package of ${absent}:\n${errors}")
endif()
find(missing Heat,SurfaceMesh ${absent})
if(status EQUAL 0 OR NOT errors MATCHES "nlohmann_json")
  message(FATAL_ERROR "SurfaceMesh must require nlohmann_json, which is missing:\n${errors}")
endif()
find(unknown Heat,Diffusion)
if(status EQUAL 0 OR NOT errors MATCHES "Shapeton has no component.*\"Diffusion\"; *its components are.*Common, Report,.*Heat,")
  message(FATAL_ERROR "the unknown component Diffusion was accepted, or the message is wrong:\n${errors}")
endif()
find(all "")
if(NOT status EQUAL 0)
  message(FATAL_ERROR "find_package(Shapeton) without components fails:\n${errors}")
endif()
find(version Common -DVERSION=0.1)
if(status EQUAL 0)
  message(FATAL_ERROR "version ${VERSION} was accepted for 0.1")
endif()

execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B "${WORK_DIR}/selection" -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
  -DSHAPETON_MODULES=Diffusion -DBUILD_TESTING=OFF OUTPUT_QUIET ERROR_VARIABLE errors RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT errors MATCHES "SHAPETON_MODULES contains the unknown *module *\"Diffusion\"")
  message(FATAL_ERROR "the unknown module Diffusion was accepted, or the message is wrong:\n${errors}")
endif()
