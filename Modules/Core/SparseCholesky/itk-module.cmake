set(DOCUMENTATION "Nested dissection, supernodes and Cholesky factors of sparse symmetric matrices whose pattern is a graph.")

itk_module(SparseCholesky
  ENABLE_SHARED
  DEPENDS
    ITKCommon
  PRIVATE_DEPENDS
    ParallelLoops
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
