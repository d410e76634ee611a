set(DOCUMENTATION "Graphs beside each other: canonical labeling, isomorphism, what differs, rotation systems carried over from one step of a
dynamic graph to the next, layouts on the sphere turned to each other.")

itk_module(ShapetonGraphComparison
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonGraphModel
    ShapetonEmbeddingCertificate
    ShapetonRicciFlowEmbedding
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
