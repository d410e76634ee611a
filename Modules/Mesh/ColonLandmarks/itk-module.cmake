set(DOCUMENTATION "Landmarks of a colon: flexures of its centreline, the loops on the wall there, six segments, folds on the surface and the three
taeniae; splitting along them.")

itk_module(ColonLandmarks
  ENABLE_SHARED
  DEPENDS
    FlatColonGrid
    Report
    SurfaceMesh
  PRIVATE_DEPENDS
    CommandLine
    ConformalFlattening
    HaustralFolds
    ITKCommon
    ParallelLoops
    SlicerMarkups
  TEST_DEPENDS
    CommandLine
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
