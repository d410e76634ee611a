set(DOCUMENTATION "Pictures without a display: axes and text, slices, surfaces and curves in views of a patient.")

itk_module(ShapetonPictureKit
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonSurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    ShapetonReport
    ShapetonMeshBridge
    ShapetonPages
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
