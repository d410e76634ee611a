set(DOCUMENTATION "Common classes: exceptions, progress, remarks, provenance, bytes, hashes and text, parallel loops, voxel sets with exact
distances, counter-based random numbers, and the optional GPU plug-in.")

itk_module(ShapetonCommon
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
