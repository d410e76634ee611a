set(DOCUMENTATION "A synthetic patient for CT colonography with known truth: the colon with its haustra, folds, taeniae and polyps, in several positions.")

itk_module(ColonPhantom
  ENABLE_SHARED
  DEPENDS
    Report
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    Base
    ShapePhantom
  TEST_DEPENDS
    VolumeFiles
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
