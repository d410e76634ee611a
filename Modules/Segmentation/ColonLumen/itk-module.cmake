set(DOCUMENTATION "The lumen of a colon in CT colonography: gas and tagged fluid without seeds, the direction of gravity, and
electronic cleansing.")

itk_module(ColonLumen
  ENABLE_SHARED
  DEPENDS
    CommandLine
    ITKCommon
  PRIVATE_DEPENDS
    LumenDistance
    ParallelLoops
    SurfaceMesh
  TEST_DEPENDS
    DicomSeries
    SurfaceMesh
    ITKGoogleTest
    ITKIOPNG
    ITKConnectedComponents
  DESCRIPTION "${DOCUMENTATION}"
)
