set(DOCUMENTATION "A page on which a person reads a virtual colonoscopy: the flat wall, the wall in space and from inside, and slices,
with one crosshair.")

itk_module(ColonViewer
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Report
  PRIVATE_DEPENDS
    Base
    SurfaceMesh
    VolumeFiles
    SlicerMarkups
    FlatColon
    HaustralFolds
    ColonLandmarks
    ColonViews
    PageKit
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
