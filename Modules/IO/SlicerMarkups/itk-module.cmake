set(DOCUMENTATION "Points and curves as markups of 3D Slicer (.mrk.json), read and written, and color tables (.ctbl) for label maps.")

itk_module(SlicerMarkups
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    SurfaceMesh
  PRIVATE_DEPENDS
    Base
    Report
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
