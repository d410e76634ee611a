set(DOCUMENTATION "Command lines declared by XML, and the inputs that tools share: volumes, surfaces, devices.")

itk_module(ShapetonCommandLine
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ShapetonReport
    ITKCommon
    ShapetonSurfaceMesh
    ShapetonVolumeFiles
  PRIVATE_DEPENDS
    ITKExpat
  TEST_DEPENDS
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
