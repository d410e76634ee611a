set(DOCUMENTATION "Graphs, rotation systems (combinatorial maps), families of graphs, and graph files in ten formats.")

itk_module(GraphModel
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
  PRIVATE_DEPENDS
    ITKExpat
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
