set(DOCUMENTATION "Surfaces, curves and images as data of VTK, and back, with arrays, direction cosines and patient space.")

itk_module(VTKData
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    SurfaceMesh
    ITKCommon
  PRIVATE_DEPENDS
    Base
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
