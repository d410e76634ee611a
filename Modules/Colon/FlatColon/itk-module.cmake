set(DOCUMENTATION "The flat wall of a colon: grids of pixels, axis, curvature, distances along the centerline.")

itk_module(FlatColon
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    SurfaceMesh
    VolumeFiles
    ITKCommon
  PRIVATE_DEPENDS
    Base
    Report
    ConformalFlattening
    HeatDiffusionMetric
    ITKIOImageBase
    ITKIONRRD
  TEST_DEPENDS
    HeatDiffusionMetric
    ITKGoogleTest
    ITKIOImageBase
    ITKIONRRD
  DESCRIPTION "${DOCUMENTATION}"
)
