set(DOCUMENTATION "The certificate of a graph embedding: rotation system, circles, places, deck transformations, and its JSON file.")

itk_module(EmbeddingCertificate
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    GraphModel
  PRIVATE_DEPENDS
    Report
  DESCRIPTION "${DOCUMENTATION}"
)
