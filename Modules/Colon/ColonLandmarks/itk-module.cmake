set(DOCUMENTATION "Landmarks of a colon: flexures of its centerline, the loops on the wall there, six segments, folds on the surface and the three
taeniae coli, and splitting along them.")

itk_module(ColonLandmarks
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SurfaceMesh
    ColonCenterline
    FlatColon
    HaustralFolds
    IleocecalValve
  PRIVATE_DEPENDS
    ConformalFlattening
  TEST_DEPENDS
    FlatColon
    HaustralFolds
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
