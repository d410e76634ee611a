set(DOCUMENTATION "Pictures of embedded graphs: SVG pictures, surfaces in space (VTP).")

itk_module(ShapetonGraphViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonEmbeddingCertificate
  PRIVATE_DEPENDS
    ShapetonCommon
    ShapetonSurfaceMesh
    ShapetonGraphModel
    ShapetonRicciFlowEmbedding
  TEST_DEPENDS
    ShapetonSurfaceMesh
    ShapetonRicciFlowEmbedding
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
