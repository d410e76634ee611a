set(DOCUMENTATION "Pictures and the report of a colon in two positions: flat walls row under row with matched folds, a checkerboard, confidence and
errors along the colon.")

itk_module(RegistrationView
  ENABLE_SHARED
  DEPENDS
    Report
    ShapeRendering
    SupineProne
  PRIVATE_DEPENDS
    ColonLandmarkView
    CommandLine
    FlatColonView
    ParallelLoops
  TEST_DEPENDS
    CommandLine
    ITKGoogleTest
    ITKCommon
  DESCRIPTION "${DOCUMENTATION}"
)
