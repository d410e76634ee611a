set(DOCUMENTATION "Shape analysis of volumes by diffusion: the volume gradient operator, cumulative and conventional heat
diffusion, heat histogram and classification.")

itk_module(ShapeDiffusion
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Devices
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
