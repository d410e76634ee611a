set(DOCUMENTATION "Embeddings of graphs on the sphere, the torus and hyperbolic surfaces by circle packings: augmentation, discrete Ricci flow
by Newton's method, layouts, deck transformations and fundamental polygons.")

itk_module(ShapetonRicciFlowEmbedding
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonGraphModel
    ShapetonEmbeddingCertificate
  PRIVATE_DEPENDS
    ShapetonSparseFactorization
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
