set(DOCUMENTATION "The lumen of a colon in CT colonography: gas and tagged fluid without seeds, the direction of gravity, and
electronic cleansing.")

itk_module(ColonLumen
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    ITKCommon
  PRIVATE_DEPENDS
    Voxels
  TEST_DEPENDS
    SurfaceMesh
    DicomSeries
    ITKConnectedComponents
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
    ITKImageFunction
    ITKSmoothing
  DESCRIPTION "${DOCUMENTATION}"
)
