set(DOCUMENTATION "Shape signatures of labels from heat content, restricted diffusion and surface spectrum, and the search for similar shapes.")

itk_module(ShapeSignature
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Voxels
    ITKCommon
  PRIVATE_DEPENDS
    HeatDiffusionMetric
    Report
    SurfaceMesh
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
