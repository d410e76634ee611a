set(DOCUMENTATION "Writers and readers of HTML reports, CSV tables and JSON documents. No VTK.")

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
