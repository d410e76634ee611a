set(DOCUMENTATION "Conformal maps of triangle surfaces to the plane by harmonic functions: cuts, distortion, handles.")

itk_module(ConformalFlattening
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SparseFactorization
    SurfaceMesh
    HeatDiffusionMetric
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
