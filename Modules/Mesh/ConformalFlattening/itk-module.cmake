set(DOCUMENTATION "Conformal maps of triangle surfaces to the plane by harmonic functions: cuts, distortion, handles.")

itk_module(ConformalFlattening
  ENABLE_SHARED
  DEPENDS
    HeatDiffusionMetric
    Report
    SurfaceMesh
  PRIVATE_DEPENDS
    CommandLine
    ITKCommon
    ParallelLoops
  TEST_DEPENDS
    CommandLine
    CounterRandom
    ITKCommon
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
