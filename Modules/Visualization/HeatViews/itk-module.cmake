set(DOCUMENTATION "Pictures of heat: histogram, transfer functions, volume rendering, slices, and the interactive explorer page.")

itk_module(ShapetonHeatViews
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonHeat
    ShapetonHeatObjects
    ShapetonPictureKit
    ShapetonPages
    ITKCommon
    ShapetonReport
  PRIVATE_DEPENDS
    ShapetonParticles
    ITKIOMeta
    ITKIONRRD
  TEST_DEPENDS
    ShapetonParticles
    ITKIONRRD
    ShapetonVolumeFiles
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
