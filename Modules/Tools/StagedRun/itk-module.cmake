set(DOCUMENTATION "A chain of tools, each in its own process and folder. Stages with unchanged inputs are skipped, a failure is
reported with the results that were kept.")

itk_module(StagedRun
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
  PRIVATE_DEPENDS
    Report
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
