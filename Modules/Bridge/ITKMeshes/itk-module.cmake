set(DOCUMENTATION "Surfaces as itk::Mesh and itk::QuadEdgeMesh, and back, with point and cell data.")

itk_module(ITKMeshes
  EXCLUDE_FROM_DEFAULT
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
