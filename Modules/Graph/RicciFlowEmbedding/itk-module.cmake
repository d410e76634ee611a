set(DOCUMENTATION "Embeddings of graphs on the sphere, the torus and hyperbolic surfaces by circle packings: augmentation, discrete
Ricci flow by Newton's method, layouts, deck transformations and fundamental polygons.")

itk_module(RicciFlowEmbedding
  ENABLE_SHARED
  DEPENDS
    EmbeddingCertificate
    GraphModel
  PRIVATE_DEPENDS
    CommandLine
    ITKCommon
    ParallelLoops
    SparseCholesky
  TEST_DEPENDS
    CounterRandom
    ITKGoogleTest
    SurfaceMesh
  DESCRIPTION "${DOCUMENTATION}"
)
