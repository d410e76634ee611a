set(DOCUMENTATION "Pictures of conformal maps.")

itk_module(SurfaceViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ConformalFlattening
    PictureKit
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
