set(DOCUMENTATION "Loops on ITK's threads whose exceptions come back to the caller.")

itk_module(ParallelLoops
  DEPENDS
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
