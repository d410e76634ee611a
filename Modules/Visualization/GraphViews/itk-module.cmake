set(DOCUMENTATION "Pictures of embedded graphs: SVG pictures, surfaces in space (VTP).")

itk_module(GraphViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    EmbeddingCertificate
  PRIVATE_DEPENDS
    Base
    SurfaceMesh
    GraphModel
    RicciFlowEmbedding
  TEST_DEPENDS
    SurfaceMesh
    EmbeddingVerification
    RicciFlowEmbedding
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
