set(DOCUMENTATION "Cumulative heat diffusion (CHD) on volumes, the heat histogram with its classes, and seeded heat segmentation.")

itk_module(ShapetonHeat
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
