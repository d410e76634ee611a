set(DOCUMENTATION "Shapeton (particle) diffusion on volumes: walks of particles along heat weights, their visits and density.")

itk_module(ShapetonParticles
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonHeat
    ITKCommon
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
