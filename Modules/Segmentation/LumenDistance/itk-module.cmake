set(DOCUMENTATION "Distance to the wall of a lumen, and what of it hangs together, from a mask.")

itk_module(LumenDistance
  ENABLE_SHARED
  DEPENDS
    ITKCommon
  PRIVATE_DEPENDS
    CommandLine
    ParallelLoops
  TEST_DEPENDS
    CommandLine
    CounterRandom
    SurfaceMesh
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
