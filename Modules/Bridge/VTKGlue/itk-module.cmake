set(DOCUMENTATION "ITK images to VTK image data and back: values, origin, spacing and direction cosines are kept.")

itk_module(VTKGlue
  ENABLE_SHARED
  DEPENDS
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
