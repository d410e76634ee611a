set(DOCUMENTATION "The lumen of a colon in CT colonography: gas and tagged fluid without seeds, the direction of gravity, and electronic
cleansing.")

itk_module(ShapetonColonLumen
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ITKCommon
  TEST_DEPENDS
    ShapetonVolumeFiles
    ITKGoogleTest
    ITKImageFunction
    ITKSmoothing
  DESCRIPTION "${DOCUMENTATION}"
)
