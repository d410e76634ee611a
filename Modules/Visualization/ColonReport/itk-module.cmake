set(DOCUMENTATION "Pictures and the HTML report of virtual colonoscopy: slices with the outline of the lumen, projections, the wall with the
centreline, and the distension chart.")

itk_module(ColonReport
  ENABLE_SHARED
  DEPENDS
    Report
    SurfaceMesh
    ColonModel
    ShapeRendering
    ITKCommon
  PRIVATE_DEPENDS
    ColonLumen
    CommandLine
    DicomSeries
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
