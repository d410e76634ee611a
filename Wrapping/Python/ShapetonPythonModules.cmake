# What the compiled module links; these need the others.
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
