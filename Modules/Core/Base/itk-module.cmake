set(DOCUMENTATION "What all modules share: exceptions, progress, remarks, provenance, bytes, hashes and words, loops over threads
and random numbers that depend on a counter alone.")

itk_module(Base
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
