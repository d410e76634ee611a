set(DOCUMENTATION "Objects of a heat volume: regions with a border.")

itk_module(ShapetonHeatObjects
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
