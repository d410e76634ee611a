set(DOCUMENTATION "Candidates for polyps seen close by, flat and from within the colon; their section of a report.")

itk_module(PolypCandidateView
  ENABLE_SHARED
  DEPENDS
    PolypCandidates
    Report
    ShapeRendering
  PRIVATE_DEPENDS
    ColonLandmarks
    CommandLine
    FlatColonGrid
    FlatColonView
    HeatDiffusionMetric
    ParallelLoops
  TEST_DEPENDS
    CommandLine
    ColonWall
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
