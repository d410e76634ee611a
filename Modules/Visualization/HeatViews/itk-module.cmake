set(DOCUMENTATION "Pictures of heat and shapeton visits: histograms, slices, volume renderings, transfer functions.")

itk_module(HeatViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Devices
    ShapeDiffusion
    PictureKit
    ITKCommon
  PRIVATE_DEPENDS
    Base
    Report
    ITKIOMeta
    ITKIONRRD
  TEST_DEPENDS
    VolumeFiles
    DicomSeries
    ITKGoogleTest
    ITKIOImageBase
    ITKIONRRD
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
