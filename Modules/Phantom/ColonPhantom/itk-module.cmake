set(DOCUMENTATION "A synthetic patient for CT colonography with known truth: the colon with its haustra, folds, taeniae and polyps, in several positions.")

itk_module(ColonPhantom
  ENABLE_SHARED
  DEPENDS
    CommandLine
    DicomSeries
    Report
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    CounterRandom
    ShapePhantom
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
