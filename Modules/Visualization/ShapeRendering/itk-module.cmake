set(DOCUMENTATION "Pictures of heat: the heat histogram, the shape-based transfer function (also as a 3D Slicer volume property),
the volume rendered with it, coloured slices, and the HTML report. Everything is drawn on the CPU, without a display.")

itk_module(ShapeRendering
  ENABLE_SHARED
  DEPENDS
    CommandLine
    Report
    VTKGlue
    ShapeDiffusion
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    DicomSeries
    ITKIOImageBase
    ITKIOMeta
    ITKIONRRD
  TEST_DEPENDS
    DicomSeries
    ITKGoogleTest
    ITKIOImageBase
    ITKIONRRD
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
