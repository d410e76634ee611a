set(DOCUMENTATION "Readers of graph files: GraphML, GML, DOT, edge lists, METIS, MATPOWER, PACE, DIMACS, graph6 and sparse6; a writer of
GraphML.")

itk_module(GraphFiles
  ENABLE_SHARED
  DEPENDS
    GraphModel
  PRIVATE_DEPENDS
    CommandLine
    ITKExpat
  TEST_DEPENDS
    CommandLine
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
