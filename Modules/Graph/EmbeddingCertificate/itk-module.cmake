set(DOCUMENTATION "Certificates of graph embeddings on surfaces: their file format and an independent verifier.")

itk_module(ShapetonEmbeddingCertificate
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonGraphModel
  PRIVATE_DEPENDS
    ShapetonReport
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
