set(DOCUMENTATION "The stages of virtual colonoscopy as ITK process objects: lumen, cleansing, centerline, wall, flattening, metric, folds,
landmarks, registration and candidates.")

itk_module(ShapetonColonFilters
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonSurfaceHeat
    ShapetonColonLumen
    ShapetonColonCenterline
    ShapetonColonModel
    ShapetonFlatColon
    ShapetonColonLandmarks
    ShapetonPolypCandidates
    ShapetonSupineProne
    ShapetonMeshBridge
    ITKCommon
    ITKImageFilterBase
    ITKMesh
  TEST_DEPENDS
    ShapetonPhantoms
    ITKGoogleTest
    ITKImageGrid
  DESCRIPTION "${DOCUMENTATION}"
)
