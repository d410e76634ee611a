set(DOCUMENTATION "Haustral folds on the flat map of a colon by a minimum cut of curvature: labels, lengths, end points and reliability.")

itk_module(HaustralFolds
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SurfaceMesh
    VolumeFiles
    SlicerMarkups
    FlatColon
    ColonCenterline
    ITKCommon
  PRIVATE_DEPENDS
    ColonLumen
    ITKIOImageBase
    ITKIONRRD
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIONRRD
  DESCRIPTION "${DOCUMENTATION}"
)
