set(DOCUMENTATION "Named signatures of shapes in one SQLite file.")

itk_module(ShapeDatabase
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapeSignature
  PRIVATE_DEPENDS
    Base
    Report
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
