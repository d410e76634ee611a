set(DOCUMENTATION "Candidates for polyps on the wall of a colon, by its curvature or by shapeton diffusion, with size, height and a score. For research use.")

itk_module(PolypCandidates
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    Report
    SurfaceMesh
    SlicerMarkups
    FlatColon
    IleocecalValve
    ITKCommon
  PRIVATE_DEPENDS
    ColonLumen
    ColonCenterline
    HeatDiffusionMetric
    VolumeFiles
    ShapeDiffusion
    ColonLandmarks
    ITKIONRRD
    ITKImageFunction
  TEST_DEPENDS
    ColonWall
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
