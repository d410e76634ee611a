set(DOCUMENTATION "Model of a colon from CT colonography or a mask of the lumen: lumen, cleansed CT, centerline, distension
and wall, with measurements and files.")

itk_module(ColonModel
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    ColonLumen
    ColonCenterline
    ColonWall
    IleocecalValve
  PRIVATE_DEPENDS
    SurfaceMesh
    ITKCommon
    ITKImageGrid
  TEST_DEPENDS
    VolumeFiles
    ColonPhantom
    ITKGoogleTest
    ITKImageGrid
  DESCRIPTION "${DOCUMENTATION}"
)
