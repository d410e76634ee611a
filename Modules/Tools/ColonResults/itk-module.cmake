set(DOCUMENTATION "The results of a virtual colonoscopy as DICOM objects: the terms of the colon, and what of an examination becomes which object.")

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
