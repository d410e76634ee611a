set(DOCUMENTATION "Candidates for polyps on the wall of a colon, by its curvature or by shapeton diffusion, with size, height and a score. For research use.")

itk_module(PolypCandidates
  ENABLE_SHARED
  DEPENDS
    Report
    SlicerMarkups
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    ColonLandmarks
    CommandLine
    DicomSeries
    FlatColonGrid
    HeatDiffusionMetric
    ITKIOImageBase
    ITKIONRRD
    ITKImageFunction
    ParallelLoops
    ShapeDiffusion
  TEST_DEPENDS
    CommandLine
    ColonWall
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
