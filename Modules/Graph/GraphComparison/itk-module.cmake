set(DOCUMENTATION "Graphs beside each other: canonical labeling, isomorphism, what differs, rotation systems carried over from one
step of a dynamic graph to the next, layouts on the sphere turned to each other.")

itk_module(GraphComparison
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    GraphModel
    GraphGenus
    EmbeddingCertificate
    RicciFlowEmbedding
  TEST_DEPENDS
    EmbeddingVerification
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
