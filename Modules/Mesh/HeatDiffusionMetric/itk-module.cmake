set(DOCUMENTATION "Cotangent Laplacian, spectrum, heat kernel and heat diffusion distance of triangle surfaces.")

itk_module(HeatDiffusionMetric
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    SparseFactorization
    SurfaceMesh
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
