set(DOCUMENTATION "Signatures of the shapes of labels, by heat that leaves them and heat that stays, and the search for like shapes.")

itk_module(ShapeSignature
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Voxels
    ITKCommon
  PRIVATE_DEPENDS
    HeatDiffusionMetric
    Report
    SurfaceMesh
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
