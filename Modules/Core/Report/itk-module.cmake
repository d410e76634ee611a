set(DOCUMENTATION "HTML reports, CSV tables, JSON documents, pages of scripts with their data, and SHA-256. No VTK.")

itk_module(ShapetonReport
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
  PRIVATE_DEPENDS
    ITKZLIB
  TEST_DEPENDS
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
