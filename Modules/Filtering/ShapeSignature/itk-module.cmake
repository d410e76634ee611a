set(DOCUMENTATION "Shape signatures of objects and a searchable signature database.")

itk_module(ShapetonShapeSignature
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ITKCommon
  PRIVATE_DEPENDS
    ShapetonSurfaceHeat
    ShapetonReport
    ShapetonSurfaceMesh
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
