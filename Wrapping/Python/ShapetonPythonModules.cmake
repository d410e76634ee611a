# Modules linked by the compiled module; these depend on all others.
set(ShapetonPython_MODULES
  ColonModel
  ConformalFlattening
  SurfaceRicciFlow
  EmbeddingCertificate
  GraphComparison
  GraphCurvature
  HeatObjects
  Particles
  Phantoms
  PolypCandidates
  ShapeSignature
  SupineProne
  ColonExamination
  VolumeFiles)
