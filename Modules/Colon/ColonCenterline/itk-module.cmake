set(DOCUMENTATION "The centerline of the colon from a mask of its lumen: distance to the wall, pieces and their order, places where loops touch,
gaps, caliber.")

itk_module(ShapetonColonCenterline
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSurfaceMesh
    ShapetonColonLumen
    ITKCommon
  TEST_DEPENDS
    ShapetonVolumeFiles
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
