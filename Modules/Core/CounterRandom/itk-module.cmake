set(DOCUMENTATION "Random numbers that depend on a key and a counter alone, so that threads may ask in any order.")

itk_module(CounterRandom
  DEPENDS
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
