set(DOCUMENTATION "Flat pictures of a colon: shaded relief, curvature, volume rendering of the CT through the wall; pages with rows, rulers, local
scales, segments and polyps.")

itk_module(FlatColonView
  ENABLE_SHARED
  DEPENDS
    FlatColonGrid
    ShapeRendering
    ITKCommon
  PRIVATE_DEPENDS
    CommandLine
    ParallelLoops
    Report
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
