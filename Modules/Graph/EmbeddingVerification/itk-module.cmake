set(DOCUMENTATION "Proof that a certificate holds: rotation system, circles, kites, angle sums, deck transformations. Shares no code with the
solver.")

itk_module(EmbeddingVerification
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    EmbeddingCertificate
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
