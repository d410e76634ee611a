set(DOCUMENTATION "Writers and readers of HTML reports, CSV tables and JSON documents. No VTK.")

itk_module(Report
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
  TEST_DEPENDS
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
