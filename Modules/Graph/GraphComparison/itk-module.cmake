set(DOCUMENTATION "Graph comparison: canonical labeling, isomorphism, differences, rotation systems transferred between the steps of a dynamic
graph, and alignment of layouts on the sphere.")

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
