# The repository as one ITK module that represents all of Modules/; see Shapeton.remote.cmake.
include(${CMAKE_CURRENT_LIST_DIR}/CMake/Modules.cmake)
list(TRANSFORM Shapeton_MODULES REPLACE "^.*/" "Shapeton" OUTPUT_VARIABLE Shapeton_modules)
if(BUILD_TESTING)
  list(APPEND Shapeton_modules ITKTestKernel) # itkTestDriver, which compares images
endif()

itk_module(Shapeton
  DEPENDS
    ${Shapeton_modules}
  EXCLUDE_FROM_DEFAULT
  DESCRIPTION "Shape-based analysis of medical volumes: heat and shapeton diffusion, virtual colonoscopy, graphs on surfaces."
)
