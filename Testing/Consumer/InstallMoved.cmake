# Makes the installation that the other tests use; see CMakeLists.txt.
include(${CMAKE_CURRENT_LIST_DIR}/Consumers.cmake)
install_moved("${PREFIX}")
