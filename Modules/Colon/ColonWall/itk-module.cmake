set(DOCUMENTATION "The wall of the colon lumen as a surface: topology-preserving growth, bridges, extraction, open ends.")

itk_module(ColonWall
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    ConformalFlattening
    HeatDiffusionMetric
    Voxels
    ITKSmoothing
  TEST_DEPENDS
    DicomSeries
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
