set(DOCUMENTATION "Conformal maps of triangle surfaces to the plane by harmonic functions: cuts, distortion, handles.")

itk_module(ShapetonConformalFlattening
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSparseFactorization
    ShapetonSurfaceMesh
    ShapetonSurfaceHeat
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
