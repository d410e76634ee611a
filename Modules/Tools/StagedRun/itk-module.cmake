set(DOCUMENTATION "A chain of tools, each in a process and a folder of its own: what is unchanged is not computed again, what failed is
told with what was kept.")

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
