set(DOCUMENTATION "Finds the ileocaecal valve of a colon in CT colonography, and the part of the lumen that is terminal ileum.")

itk_module(IleocaecalValve
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    SurfaceMesh
    ColonLumen
  PRIVATE_DEPENDS
    Base
    Voxels
    ITKCommon
    ITKImageFunction
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
