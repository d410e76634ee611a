set(DOCUMENTATION "The colon made visible: slices, projections, the flat colon and what is marked on it, supine beside prone,
polyp candidates seen close by.")

itk_module(ColonViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Devices
    SurfaceMesh
    ColonCentreline
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
