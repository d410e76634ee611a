set(DOCUMENTATION "Haustral folds on the flat map of a colon by a least cut of curvature: labels, lengths, end points and how sure they are.")

itk_module(HaustralFolds
  ENABLE_SHARED
  DEPENDS
    DicomSeries
    FlatColonGrid
    Report
    SlicerMarkups
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    CommandLine
    HeatDiffusionMetric
    ITKIOImageBase
    ITKIONRRD
    ParallelLoops
  TEST_DEPENDS
    CommandLine
    HeatDiffusionMetric
    ITKGoogleTest
    ITKIOImageBase
    ITKIONRRD
  DESCRIPTION "${DOCUMENTATION}"
)
