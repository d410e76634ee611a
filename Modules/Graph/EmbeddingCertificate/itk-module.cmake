set(DOCUMENTATION "The certificate of a graph embedding: rotation system, circles, places, deck transformations; its JSON file.")

itk_module(EmbeddingCertificate
  ENABLE_SHARED
  DEPENDS
    Base
    GraphModel
  PRIVATE_DEPENDS
    Report
  DESCRIPTION "${DOCUMENTATION}"
)
