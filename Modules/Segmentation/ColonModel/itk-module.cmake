set(DOCUMENTATION "From CT colonography, or a mask of the lumen, to the model of a colon: lumen, cleansed CT, centreline, distension
and wall, with what was measured and the files that hold it.")

itk_module(ColonModel
  ENABLE_SHARED
  DEPENDS
    ColonLumen
    ColonCentreline
    ColonWall
    LumenDistance
    CommandLine
    DicomSeries
    Report
  TEST_DEPENDS
    ITKGoogleTest
    ColonPhantom
  DESCRIPTION "${DOCUMENTATION}"
)
