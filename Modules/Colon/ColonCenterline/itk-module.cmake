set(DOCUMENTATION "The centerline of the colon from a mask of its lumen: distance to the wall, pieces and their order, places where
loops touch, gaps, caliber.")

itk_module(ColonCenterline
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SurfaceMesh
    ColonLumen
    ITKCommon
  PRIVATE_DEPENDS
    Voxels
  TEST_DEPENDS
    DicomSeries
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
