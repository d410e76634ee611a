set(proj Spectra)
set(${proj}_DEPENDS Eigen3)
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
simple_project(${proj} VERSION v1.0.1 GIT https://github.com/yixuan/spectra.git CACHE -DEigen3_DIR:PATH=${Eigen3_DIR})
