set(DOCUMENTATION "Writers of HTML reports, CSV tables and JSON documents. No VTK.")

itk_module(Report
  ENABLE_SHARED
  DEPENDS
    CommandLine
  TEST_DEPENDS
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
