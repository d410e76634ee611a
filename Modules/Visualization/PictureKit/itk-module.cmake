set(DOCUMENTATION "Pictures without a display: axes and text, slices, surfaces and curves in views of a patient.")

itk_module(PictureKit
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    Report
    VTKData
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
