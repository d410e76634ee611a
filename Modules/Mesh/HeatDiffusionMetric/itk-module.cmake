set(DOCUMENTATION "Cotangent Laplacian, spectrum, heat kernel and heat diffusion distance of triangle surfaces; selected inversion of sparse complex-symmetric matrices.")

itk_module(HeatDiffusionMetric
  ENABLE_SHARED
  DEPENDS
    SurfaceMesh
  PRIVATE_DEPENDS
    Base
    SparseCholesky
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
