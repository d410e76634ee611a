set(DOCUMENTATION "Results as DICOM objects that reference their source series: segmentations, measurement reports, parametric maps, pictures
and surfaces, and readers for segmentations and the points of reports.")

itk_module(ShapetonDicomResults
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonSurfaceMesh
    ShapetonVolumeFiles
    ITKCommon
  PRIVATE_DEPENDS
    ShapetonReport
    ShapetonCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
