set(DOCUMENTATION "Shared parts of the graph tools: graphs from command line parameters, interactive reports.")

itk_module(ShapetonGraphTools
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonReport
    ShapetonGraphModel
    ShapetonRicciFlowEmbedding
    ShapetonGraphComparison
    ShapetonGraphCurvature
    ShapetonGraphViews
  PRIVATE_DEPENDS
    ShapetonCommandLine
    ShapetonPages
  TEST_DEPENDS
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
