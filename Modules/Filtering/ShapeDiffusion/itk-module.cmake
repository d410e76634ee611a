set(DOCUMENTATION "Shape analysis of volumes by diffusion: the volume gradient operator, cumulative and conventional heat
diffusion, heat histogram and classification.")

itk_module(ShapeDiffusion
  ENABLE_SHARED
  DEPENDS
    ITKCommon
  PRIVATE_DEPENDS
    CounterRandom
    ParallelLoops
  TEST_DEPENDS
    ITKGoogleTest
    ITKTestKernel
  DESCRIPTION "${DOCUMENTATION}"
)
