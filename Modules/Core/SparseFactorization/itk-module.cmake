set(DOCUMENTATION "Sparse symmetric matrices: elimination order, supernodes, Cholesky factorization of real matrices, selected inversion of
complex ones.")

itk_module(ShapetonSparseFactorization
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
  TEST_DEPENDS
    ITKCommon
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
