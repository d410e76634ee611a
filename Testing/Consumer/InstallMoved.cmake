# Creates the installation used by the other tests; see CMakeLists.txt.
include(${CMAKE_CURRENT_LIST_DIR}/Consumers.cmake)
install_moved("${PREFIX}")
