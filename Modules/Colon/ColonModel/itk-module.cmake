set(DOCUMENTATION "From CT colonography, or a mask of the lumen, to the model of a colon: lumen, cleansed CT, centreline, distension
and wall, with what was measured and the files that hold it.")

itk_module(ColonModel
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    ColonLumen
    ColonCentreline
    ColonWall
    IleocaecalValve
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
