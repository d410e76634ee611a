set(DOCUMENTATION "Landmarks of a colon: flexures of its centerline, the loops on the wall there, six segments, folds on the surface and the
three taeniae coli, and splitting along them.")

itk_module(ShapetonColonLandmarks
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSurfaceMesh
    ShapetonColonCenterline
    ShapetonFlatColon
    ShapetonColonModel
    ITKCommon
  PRIVATE_DEPENDS
    ITKImageFunction
    ShapetonConformalFlattening
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
