set(DOCUMENTATION "Conversions of surfaces and images between Shapeton, ITK and VTK.")

itk_module(ShapetonMeshBridge
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonSurfaceMesh
    ITKCommon
    ITKMesh
  TEST_DEPENDS
    ITKGoogleTest
    ITKQuadEdgeMesh
  DESCRIPTION "${DOCUMENTATION}"
)
