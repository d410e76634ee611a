# Modules linked by the compiled module, which depend on the others.
set(ShapetonPython_MODULES
  ColonModel
  ColonPhantom
  ConformalFlattening
  DicomSeries
  EmbeddingVerification
  GraphComparison
  PolypCandidates
  SeededHeat
  ShapeDatabase
  ShapeDiffusion
  SupineProne)
