set(DOCUMENTATION "Shared parts of the graph tools: graphs from command line parameters, interactive reports.")

itk_module(GraphTools
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Report
    GraphModel
    RicciFlowEmbedding
    GraphComparison
    GraphViews
  PRIVATE_DEPENDS
    Base
    PageKit
    CommandLine
  TEST_DEPENDS
    EmbeddingVerification
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
