# Modules linked by the compiled module, which depend on the others.
set(ShapetonPython_MODULES
  ColonModel
  ConformalFlattening
  EmbeddingCertificate
  GraphComparison
  Particles
  Phantoms
  PolypCandidates
  ShapeSignature
  SupineProne
  VolumeFiles)
