set(DOCUMENTATION "The stages of virtual colonoscopy as ITK process objects: lumen, cleansing, centerline, wall, flattening, metric, folds, landmarks,
registration and candidates.")

itk_module(ColonFilters
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    VolumeFiles
    HeatDiffusionMetric
    ConformalFlattening
    ColonLumen
    ColonCenterline
    ColonWall
    ColonModel
    FlatColon
    HaustralFolds
    ColonLandmarks
    PolypCandidates
    SupineProne
    ITKMeshes
    ITKCommon
    ITKImageFilterBase
    ITKMesh
  TEST_DEPENDS
    ColonPhantom
    ITKGoogleTest
    ITKImageGrid
  DESCRIPTION "${DOCUMENTATION}"
)
