set(DOCUMENTATION "Virtual colonoscopy from the CT to the report: the stages and what feeds what, the report on all of them, files for 3D
Slicer.")

itk_module(ColonoscopyRun
  ENABLE_SHARED
  DEPENDS
    Base
    Report
    SurfaceMesh
    ColonLandmarks
    PolypCandidates
    SupineProne
    StagedRun
    ITKCommon
  PRIVATE_DEPENDS
    DicomSeries
    SlicerMarkups
    PictureKit
    ColonViews
    CommandLine
    ColonTools
    ITKIOImageBase
    ITKIONRRD
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
