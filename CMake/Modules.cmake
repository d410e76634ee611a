# The modules of Shapeton, each one after all it depends on. This list is the only place that names them;
# ModuleLayeringTest checks that no include points to a later one.
set(Shapeton_MODULES
  Core/CommandLine
  Core/CounterRandom
  Core/ParallelLoops
  Core/Report
  Core/SparseCholesky
  Bridge/VTKGlue
  IO/DicomSeries
  Mesh/SurfaceMesh
  Mesh/HeatDiffusionMetric
  Mesh/ConformalFlattening
  Mesh/FlatColonGrid
  Filtering/ShapeDiffusion
  Phantom/ShapePhantom
  Phantom/ColonPhantom
  Segmentation/LumenDistance
  Segmentation/ColonLumen
  Segmentation/ColonCentreline
  Segmentation/ColonWall
  Segmentation/ColonModel
  Graph/GraphModel
  Visualization/ShapeRendering
  Visualization/ConformalMapView
  Visualization/ColonReport
  Visualization/FlatColonView
)
