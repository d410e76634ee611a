set(DOCUMENTATION "A synthetic patient for CT colonography with ground truth: the colon with haustra, folds, taeniae coli and polyps, in several positions.")

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
