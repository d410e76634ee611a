set(DOCUMENTATION "Pictures and a report of the landmarks of a colon: segments, taeniae and flexures on the wall and on the flat map.")

itk_module(ColonLandmarkView
  ENABLE_SHARED
  DEPENDS
    ColonLandmarks
    FlatColonView
    Report
    ShapeRendering
  PRIVATE_DEPENDS
    CommandLine
  TEST_DEPENDS
    ITKGoogleTest
    ITKCommon
  DESCRIPTION "${DOCUMENTATION}"
)
