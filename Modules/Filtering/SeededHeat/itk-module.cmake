set(DOCUMENTATION "Segmentation from seeds: the steady state of heat that leaves each label's seeds, on the conductances of
the volume gradient operator.")

itk_module(SeededHeat
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    ITKCommon
    ShapeDiffusion
  PRIVATE_DEPENDS
    Voxels
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
