set(DOCUMENTATION "CSV tables, JSON documents, base64 and SHA-256.")

itk_module(ShapetonReport
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
