set(DOCUMENTATION "Results as DICOM objects beside the series that they were made from: segmentations, measurement reports, parametric maps,
pictures and surfaces, and segmentations and the points of reports read back.")

itk_module(ShapetonDicomResults
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonSurfaceMesh
    ShapetonVolumeFiles
    ITKCommon
  PRIVATE_DEPENDS
    ShapetonCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
