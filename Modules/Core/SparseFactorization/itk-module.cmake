set(DOCUMENTATION "Sparse symmetric matrices: order of elimination, supernodes, Cholesky factors of real matrices, selected inversion of
complex ones.")

itk_module(SparseFactorization
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
  TEST_DEPENDS
    ITKCommon
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
