set(DOCUMENTATION "Synthetic volumes with known truth: boxes, spheres, tubes and deformed objects described by signed distance
functions in physical millimetres, rasterised as an image in Hounsfield units and a label image.")

itk_module(ShapePhantom
  ENABLE_SHARED
  DEPENDS
    CommandLine
    Report
    ITKCommon
  PRIVATE_DEPENDS
    CounterRandom
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
