set(DOCUMENTATION "A page on which a person picks lines of the heat histogram and sees them on slices and in space.")

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
