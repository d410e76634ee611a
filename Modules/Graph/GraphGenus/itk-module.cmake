set(DOCUMENTATION "Embeddings of graphs on surfaces of small genus: planarity by Boyer and Myrvold, reduction to kernels, annealed
re-insertion of edges, lower bounds.")

itk_module(GraphGenus
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    GraphModel
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
