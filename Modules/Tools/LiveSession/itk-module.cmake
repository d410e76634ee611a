set(DOCUMENTATION "A live session of diffusion: state and commands, the server of its page, and the script that repeats it.")

itk_module(ShapetonLiveSession
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonReport
    ShapetonHeat
    ShapetonParticles
    ShapetonVolumeFiles
  PRIVATE_DEPENDS
    ShapetonPages
    ITKCommon
    ShapetonCommon
    ShapetonHeatObjects
    ShapetonPictureKit
    ShapetonHeatViews
    ShapetonCommandLine
    ShapetonHeatTools
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
