set(DOCUMENTATION "Shape analysis of volumes by diffusion: the volume gradient operator, cumulative heat diffusion,
shapeton diffusion, heat histogram and classification.")

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
