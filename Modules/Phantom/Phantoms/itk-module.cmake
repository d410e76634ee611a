set(DOCUMENTATION "Synthetic volumes with known truth: simple shapes and patients with a colon, as images and DICOM series.")

itk_module(ShapetonPhantoms
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ITKCommon
    ITKImageSources
    ShapetonReport
    ShapetonSurfaceMesh
  PRIVATE_DEPENDS
    ShapetonVolumeFiles
  TEST_DEPENDS
    ITKGoogleTest
    ShapetonVolumeFiles
  DESCRIPTION "${DOCUMENTATION}"
)
