set(DOCUMENTATION "Nested dissection, supernodes and Cholesky factors of sparse symmetric matrices whose pattern is a graph.")

itk_module(SparseCholesky
  ENABLE_SHARED
  PRIVATE_DEPENDS
    Base
  TEST_DEPENDS
    ITKCommon
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
