set(DOCUMENTATION "Cotangent Laplacian, spectrum, heat kernel and heat diffusion distance of triangle surfaces; selected inversion of sparse complex-symmetric matrices.")

itk_module(HeatDiffusionMetric
  ENABLE_SHARED
  DEPENDS
    SurfaceMesh
  PRIVATE_DEPENDS
    CommandLine
    ITKCommon
    ParallelLoops
    SparseCholesky
  TEST_DEPENDS
    CommandLine
    CounterRandom
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
