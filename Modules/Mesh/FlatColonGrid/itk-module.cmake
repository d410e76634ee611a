set(DOCUMENTATION "The regular grid on the flat map of a tube: face, point in space, normal, curvature and scale of each pixel; coordinate map;
points in space to pixels; the axis of the tube, rows and rulers.")

itk_module(FlatColonGrid
  ENABLE_SHARED
  DEPENDS
    DicomSeries
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    CommandLine
    ConformalFlattening
    ITKIOImageBase
    ITKIONRRD
    ParallelLoops
    Report
  TEST_DEPENDS
    CommandLine
    ITKGoogleTest
    ITKIOImageBase
    ITKIONRRD
  DESCRIPTION "${DOCUMENTATION}"
)
