set(DOCUMENTATION "Sets of voxels: index arithmetic, runs and their connected components, exact distances.")

itk_module(Voxels
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
