set(DOCUMENTATION "Result files and reports shared by the colon tools.")

itk_module(ColonTools
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SurfaceMesh
    ConformalFlattening
    ColonModel
    ColonLandmarks
    PolypCandidates
    SupineProne
    ColonViews
  PRIVATE_DEPENDS
    VolumeFiles
    SlicerMarkups
    ColonPhantom
    ColonLumen
    FlatColon
    PictureKit
    CommandLine
    ToolInput
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
