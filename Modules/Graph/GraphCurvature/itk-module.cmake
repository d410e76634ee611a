set(DOCUMENTATION "Discrete Ricci curvature of graphs (Ollivier, Lin-Lu-Yau, Forman), and the conformal type of growing planar graphs by
circle packing and effective resistance.")

itk_module(ShapetonGraphCurvature
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonGraphModel
  PRIVATE_DEPENDS
    ShapetonSparseFactorization
    ShapetonRicciFlowEmbedding
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
