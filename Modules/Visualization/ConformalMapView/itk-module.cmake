set(DOCUMENTATION "Pictures of conformal maps: checkerboards, polar checkerboards and level sets on a surface and on the plane.")

itk_module(ConformalMapView
  ENABLE_SHARED
  DEPENDS
    ConformalFlattening
    ShapeRendering
    SurfaceMesh
  PRIVATE_DEPENDS
    CommandLine
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
