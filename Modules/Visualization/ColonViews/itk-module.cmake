set(DOCUMENTATION "Pictures of surfaces and colons, and the offline viewer page of an examination.")

itk_module(ShapetonColonViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonConformalFlattening
    ShapetonPictureKit
    ShapetonCommon
    ShapetonSurfaceMesh
    ShapetonColonCenterline
    ShapetonFlatColon
    ShapetonColonLandmarks
    ShapetonPolypCandidates
    ShapetonSupineProne
  PRIVATE_DEPENDS
    ShapetonColonExamination
    ShapetonPages
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
