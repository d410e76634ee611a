set(DOCUMENTATION "The colon wall unrolled on a plane, sampled on a grid, and the haustral folds found on it.")

itk_module(ShapetonFlatColon
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonSurfaceMesh
    ShapetonVolumeFiles
    ShapetonConformalFlattening
    ITKCommon
    ShapetonCommon
    ShapetonReport
    ShapetonColonCenterline
  PRIVATE_DEPENDS
    ShapetonSurfaceHeat
    ITKIOImageBase
    ITKIONRRD
    ShapetonColonLumen
  TEST_DEPENDS
    ShapetonSurfaceHeat
    ITKIOImageBase
    ITKIONRRD
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
