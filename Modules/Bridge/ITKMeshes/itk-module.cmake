set(DOCUMENTATION "Surfaces as itk::Mesh and itk::QuadEdgeMesh, and back, with point and cell data.")

itk_module(ITKMeshes
  DEPENDS
    Base
    SurfaceMesh
    ITKCommon
    ITKMesh
  TEST_DEPENDS
    ITKGoogleTest
    ITKQuadEdgeMesh
  DESCRIPTION "${DOCUMENTATION}"
)
