set(DOCUMENTATION "Results and reports of the colon tools, DICOM results, and resumable runs of whole examinations.")

itk_module(ShapetonColonTools
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSurfaceMesh
    ShapetonColonModel
    ShapetonColonLandmarks
    ShapetonPolypCandidates
    ShapetonSupineProne
    ShapetonColonExamination
    ShapetonColonViews
    ShapetonDicomResults
    ShapetonPages
  PRIVATE_DEPENDS
    ShapetonVolumeFiles
    ShapetonPhantoms
    ShapetonColonLumen
    ShapetonFlatColon
    ShapetonPictureKit
    ShapetonCommandLine
    ITKCommon
    ITKIONRRD
    ITKIOPNG
  TEST_DEPENDS
    ITKIOPNG
    ITKCommon
    ITKGoogleTest
    ITKIOImageBase
  DESCRIPTION "${DOCUMENTATION}"
)
