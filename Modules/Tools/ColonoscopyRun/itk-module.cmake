set(DOCUMENTATION "Virtual colonoscopy from the CT to the report: the stages and their inputs, the report, files for 3D Slicer.")

itk_module(ColonoscopyRun
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  PRIVATE_DEPENDS
    Devices
    HaustralFolds
    Base
    Report
    SurfaceMesh
    VolumeFiles
    SlicerMarkups
    FlatColon
    ColonLandmarks
    PolypCandidates
    SupineProne
    PictureKit
    ColonViews
    CommandLine
    ToolInput
    StagedRun
    ColonTools
    ITKCommon
  TEST_DEPENDS
    Devices
    Base
    Report
    SurfaceMesh
    ColonLandmarks
    PolypCandidates
    SupineProne
    StagedRun
    ITKCommon
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
