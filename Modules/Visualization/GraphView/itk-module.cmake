set(DOCUMENTATION "Pictures of embedded graphs: SVG of graph, dual, overlap graph, circles and tilings, VTP, and an offline HTML report with a view
that turns, zooms and moves by Moebius transformations.")

itk_module(GraphView
  ENABLE_SHARED
  DEPENDS
    EmbeddingCertificate
    Report
  PRIVATE_DEPENDS
    CommandLine
    RicciFlowEmbedding
    SurfaceMesh
  TEST_DEPENDS
    CommandLine
    EmbeddingCertificate
    ITKExpat
    ITKGoogleTest
    SurfaceMesh
  DESCRIPTION "${DOCUMENTATION}"
)
