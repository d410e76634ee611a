set(DOCUMENTATION "Candidates for polyps on the wall of a colon, by its curvature or by shapeton diffusion, with size, height and a score. For
research use.")

itk_module(ShapetonPolypCandidates
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonSurfaceMesh
    ShapetonFlatColon
    ShapetonColonModel
    ITKCommon
  PRIVATE_DEPENDS
    ShapetonColonLumen
    ShapetonColonCenterline
    ShapetonSurfaceHeat
    ShapetonHeat
    ShapetonParticles
    ShapetonColonLandmarks
    ITKImageFunction
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
