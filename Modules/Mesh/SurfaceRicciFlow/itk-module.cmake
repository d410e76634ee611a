set(DOCUMENTATION "Discrete Ricci flow of triangle surfaces: metrics of prescribed curvature, conformal to the surface.")

itk_module(ShapetonSurfaceRicciFlow
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSurfaceMesh
    ShapetonConformalFlattening
  PRIVATE_DEPENDS
    ShapetonSparseFactorization
    ShapetonSurfaceHeat
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
