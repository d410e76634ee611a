set(DOCUMENTATION "What all modules share: exceptions, progress, remarks, provenance, bytes, hashes and words, loops over threads, sets of
voxels with exact distances, random numbers that depend on a counter alone, and the optional GPU plug-in.")

itk_module(ShapetonCommon
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
