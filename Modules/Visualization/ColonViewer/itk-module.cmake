set(DOCUMENTATION "A page for reading a virtual colonoscopy: the flat wall, the wall in space, the endoluminal view and slices with a
linked crosshair.")

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
