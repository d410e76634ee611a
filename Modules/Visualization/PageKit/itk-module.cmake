set(DOCUMENTATION "Script pages that open from a file: data blocks, the page around them, and shared scripts.")

itk_module(PageKit
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Report
  PRIVATE_DEPENDS
    Base
    ITKZLIB
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
