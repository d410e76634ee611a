set(DOCUMENTATION "The folder of a virtual colonoscopy: names, formats and typed readers of its files, records of its stages, verdicts of
its reader.")

itk_module(ShapetonColonExamination
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSurfaceMesh
    ShapetonColonLandmarks
    ShapetonPolypCandidates
    ShapetonSupineProne
    ITKCommon
  PRIVATE_DEPENDS
    ShapetonVolumeFiles
    ShapetonFlatColon
    ITKIONRRD
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
