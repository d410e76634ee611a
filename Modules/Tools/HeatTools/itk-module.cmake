set(DOCUMENTATION "Shared parts of the heat and shapeton diffusion tools: result files, reports, and the monitor of a run.")

itk_module(ShapetonHeatTools
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ShapetonHeat
    ShapetonHeatObjects
    ShapetonParticles
    ShapetonSurfaceMesh
    ShapetonVolumeFiles
    ShapetonPictureKit
    ShapetonHeatViews
    ITKCommon
  PRIVATE_DEPENDS
    ShapetonDicomResults
    ShapetonMeshBridge
    ShapetonCommandLine
    ShapetonPages
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOImageBase
    ITKIOPNG
  DESCRIPTION "${DOCUMENTATION}"
)
