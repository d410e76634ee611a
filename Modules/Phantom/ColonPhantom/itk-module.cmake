set(DOCUMENTATION "A synthetic patient for CT colonography with known truth: the colon with its haustra, folds, taeniae and polyps, in several positions.")

itk_module(ColonPhantom
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SurfaceMesh
    ITKCommon
    ITKImageSources
  PRIVATE_DEPENDS
    ShapePhantom
  TEST_DEPENDS
    VolumeFiles
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
