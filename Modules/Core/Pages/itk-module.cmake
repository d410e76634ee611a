set(DOCUMENTATION "HTML reports, pages of scripts with their data, PDF files, and numbers for readers. No VTK.")

itk_module(ShapetonPages
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
  PRIVATE_DEPENDS
    ITKZLIB
  TEST_DEPENDS
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
