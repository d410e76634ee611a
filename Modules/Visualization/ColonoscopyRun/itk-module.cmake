set(DOCUMENTATION "Virtual colonoscopy from the CT to the report: the stages and what feeds what, the report on all of them, files for 3D
Slicer.")

itk_module(ColonoscopyRun
  ENABLE_SHARED
  DEPENDS
    ColonLandmarks
    PolypCandidates
    Report
    StagedRun
    SupineProne
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    ColonLandmarkView
    ColonReport
    CommandLine
    DicomSeries
    FlatColonView
    PolypCandidateView
    RegistrationView
    ShapeRendering
    SlicerMarkups
    ITKIOImageBase
    ITKIONRRD
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
