# Builds a program of Examples/ with its required components and runs it; see CMakeLists.txt.
include(${CMAKE_CURRENT_LIST_DIR}/Consumers.cmake)
consume("${PREFIX}" "${WORK_DIR}/build" ${VERSION} "${MODULES}" ${PROGRAM})
run("${WORK_DIR}/build/Consumer" ${ARGUMENTS})
expect("${STDOUT}")
message("${out}")
