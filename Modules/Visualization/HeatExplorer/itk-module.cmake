set(DOCUMENTATION "A page for selecting lines of the heat histogram, shown on slices and in a rendering.")

itk_module(HeatExplorer
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Report
    ShapeDiffusion
    HeatViews
    PageKit
    ITKCommon
  PRIVATE_DEPENDS
    Base
    PictureKit
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
