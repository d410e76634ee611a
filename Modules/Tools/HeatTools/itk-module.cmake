set(DOCUMENTATION "Shared parts of the heat and shapeton diffusion tools: result files, reports, and the monitor of a run.")

itk_module(HeatTools
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SeededHeat
    SurfaceMesh
    SlicerMarkups
    VolumeFiles
    ShapeDiffusion
    PictureKit
    HeatViews
    HeatExplorer
    ITKCommon
  PRIVATE_DEPENDS
    DicomResults
    CommandLine
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
