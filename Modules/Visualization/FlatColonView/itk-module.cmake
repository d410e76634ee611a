set(DOCUMENTATION "Flat pictures of a colon: shaded relief, curvature, volume rendering of the CT through the wall; pages with rows, rulers, local
scales, segments and polyps.")

itk_module(FlatColonView
  ENABLE_SHARED
  DEPENDS
    ConformalFlattening
    FlatColonGrid
    Report
    ShapeRendering
    ITKCommon
  PRIVATE_DEPENDS
    CommandLine
    ITKImageFunction
    ParallelLoops
  TEST_DEPENDS
    CounterRandom
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
