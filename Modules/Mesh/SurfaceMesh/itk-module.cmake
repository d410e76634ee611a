set(DOCUMENTATION "Triangle surfaces: files, connectivity, defects and quality, repair, simplification, remeshing, closest points.")

itk_module(SurfaceMesh
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
