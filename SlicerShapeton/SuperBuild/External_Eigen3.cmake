set(proj Eigen3)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
simple_project(${proj} VERSION 3.4.0 GIT https://gitlab.com/libeigen/eigen.git
  CACHE -DEIGEN_BUILD_DOC:BOOL=OFF -DEIGEN_BUILD_PKGCONFIG:BOOL=OFF -DCMAKE_Fortran_COMPILER:FILEPATH=)
set(Eigen3_DIR ${ep_prefix}/share/eigen3/cmake)
