set(DOCUMENTATION "The colon of a CT or of a lumen mask: wall surface, ileocecal valve, and a model of lumen, centerline and wall.")

itk_module(ShapetonColonModel
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonSurfaceMesh
    ITKCommon
    ShapetonColonLumen
    ShapetonReport
    ShapetonColonCenterline
  PRIVATE_DEPENDS
    ShapetonConformalFlattening
    ShapetonSurfaceHeat
    ITKSmoothing
    ITKImageFunction
    ITKImageGrid
  TEST_DEPENDS
    ITKImageGrid
    ShapetonVolumeFiles
    ITKGoogleTest
    ShapetonPhantoms
  DESCRIPTION "${DOCUMENTATION}"
)
