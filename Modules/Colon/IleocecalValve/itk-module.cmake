set(DOCUMENTATION "Finds the ileocecal valve of a colon in CT colonography, and the part of the lumen that is terminal ileum.")

itk_module(IleocecalValve
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
