set(DOCUMENTATION "Results of a virtual colonoscopy as DICOM objects, and DICOM objects as inputs of the colon tools.")

itk_module(ColonResults
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SlicerMarkups
    DicomResults
  PRIVATE_DEPENDS
    SurfaceMesh
    VolumeFiles
    ColonWall
    HaustralFolds
    ColonLandmarks
    PolypCandidates
    PictureKit
    ColonViews
    StagedRun
    ITKCommon
    ITKIONRRD
    ITKIOPNG
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
