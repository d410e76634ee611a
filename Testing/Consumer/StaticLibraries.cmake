# Builds and installs static libraries of MODULES and their dependencies; see CMakeLists.txt.
include(${CMAKE_CURRENT_LIST_DIR}/Consumers.cmake)
file(WRITE "${WORK_DIR}/modules.cmake" "set(SHAPETON_MODULES ${MODULES} CACHE STRING \"\")\n")
configure(${SOURCE_DIR} "${WORK_DIR}/static" -C "${WORK_DIR}/modules.cmake" -DBUILD_TESTING=OFF -DBUILD_SHARED_LIBS=OFF
  "-DCMAKE_INSTALL_PREFIX=${PREFIX}") # static libraries search their program there
run(${CMAKE_COMMAND} --build "${WORK_DIR}/static" --parallel ${JOBS})
file(REMOVE_RECURSE "${PREFIX}")
run(${CMAKE_COMMAND} --install "${WORK_DIR}/static")
file(GLOB shared "${PREFIX}/lib/*.so*")
if(shared)
  message(FATAL_ERROR "a static build installed ${shared}")
endif()
