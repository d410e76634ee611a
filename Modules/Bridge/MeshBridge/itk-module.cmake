set(DOCUMENTATION "Conversions between the surfaces and images of Shapeton and those of ITK and VTK.")

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
