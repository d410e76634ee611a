set(DOCUMENTATION "Triangle surfaces, their files, repair, simplification and topology, and the markups and color
tables of 3D Slicer.")

itk_module(ShapetonSurfaceMesh
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
