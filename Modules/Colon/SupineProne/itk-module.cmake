set(DOCUMENTATION "One-to-one map between the walls of a colon in two positions, supine and prone: start frame from flexures and taeniae,
cylindrical dynamic time warping, matching of haustral folds, robust smooth correction, projection to a bijection.")

itk_module(ShapetonSupineProne
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSurfaceMesh
    ShapetonFlatColon
    ShapetonColonCenterline
    ShapetonColonLandmarks
  PRIVATE_DEPENDS
    ShapetonSparseFactorization
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
