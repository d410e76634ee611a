set(DOCUMENTATION "Objects of a heat volume: connected regions that are stable over a range of heat.")

itk_module(ShapetonHeatObjects
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonHeat
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
