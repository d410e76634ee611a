set(DOCUMENTATION "What tools of graphs share: graphs by the parameters of a command line, interactive reports.")

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
