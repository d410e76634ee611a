set(DOCUMENTATION "Synthetic volumes with known truth: boxes, spheres, tubes and deformed objects described by signed distance
functions in physical millimeters, rasterized as an image in Hounsfield units and a label image.")

itk_module(ShapePhantom
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    ITKCommon
    ITKImageSources
  PRIVATE_DEPENDS
    Report
  TEST_DEPENDS
    Base
    Report
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
