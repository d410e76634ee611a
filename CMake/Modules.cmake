# The modules of Shapeton, each one after all it depends on. This list is the only place that names them;
# ModuleLayeringTest checks that no include points to a later one.
set(Shapeton_MODULES
  Core/CommandLine
  Core/CounterRandom
  Core/Report
  Bridge/VTKGlue
  IO/DicomSeries
  Mesh/SurfaceMesh
  Segmentation/ColonLumen
  Filtering/ShapeDiffusion
  Phantom/ShapePhantom
  Phantom/ColonPhantom
  Segmentation/ColonCentreline
  Segmentation/ColonWall
  Visualization/ShapeRendering
  Visualization/ColonReport
)
