set(DOCUMENTATION "A synthetic patient for CT colonography with known truth: the colon with its haustra, folds, taeniae and polyps, in several positions.")

itk_module(ColonPhantom
  ENABLE_SHARED
  DEPENDS
    CommandLine
    DicomSeries
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    CounterRandom
    Report
    ShapePhantom
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
