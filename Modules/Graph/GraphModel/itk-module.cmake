set(DOCUMENTATION "Graphs, combinatorial maps (rotation systems), their faces, genus, dual and overlap graph; components, blocks and
families of known graphs.")

itk_module(GraphModel
  ENABLE_SHARED
  DEPENDS
    CommandLine
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
