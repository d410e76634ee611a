set(DOCUMENTATION "Pictures of a colon: slices, projections, the annotated flat colon, supine and prone walls side by side,
close-ups of polyp candidates.")

itk_module(ColonViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Devices
    SurfaceMesh
    ColonCenterline
    FlatColon
    HaustralFolds
    ColonLandmarks
    PolypCandidates
    SupineProne
    PictureKit
  PRIVATE_DEPENDS
    Base
    Report
    VolumeFiles
    ITKCommon
  TEST_DEPENDS
    ColonWall
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
