set(DOCUMENTATION "Pictures of embedded graphs: SVG pictures, surfaces in space (VTP).")

itk_module(ShapetonGraphViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonEmbeddingCertificate
    ShapetonSurfaceMesh
  PRIVATE_DEPENDS
    ShapetonConformalFlattening
    ShapetonSurfaceRicciFlow
    ShapetonGraphModel
    ShapetonRicciFlowEmbedding
  TEST_DEPENDS
    ShapetonRicciFlowEmbedding
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
