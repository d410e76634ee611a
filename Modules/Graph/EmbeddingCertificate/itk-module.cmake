set(DOCUMENTATION "The certificate of a graph embedding: rotation system, circles, places, deck transformations; its JSON file.")

itk_module(EmbeddingCertificate
  ENABLE_SHARED
  DEPENDS
    GraphModel
  PRIVATE_DEPENDS
    CommandLine
    Report
  TEST_DEPENDS
    CommandLine
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
