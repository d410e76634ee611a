set(DOCUMENTATION "Cotangent Laplacian, spectrum, heat kernel and heat diffusion distance of triangle surfaces.")

itk_module(ShapetonSurfaceHeat
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonSparseFactorization
    ShapetonSurfaceMesh
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
