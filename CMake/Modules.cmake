# The groups of modules; each may use the groups before it.
set(Shapeton_GROUPS Core Mesh IO Filtering Phantom Graph Colon Bridge Visualization Tools)

# The modules of Shapeton, each after its dependencies. This is the only list of modules; the test ModuleLayersOfThisRepository
# checks that modules include only earlier modules.
set(Shapeton_MODULES
  Core/Common
  Core/Report
  Core/Pages
  Core/SparseFactorization
  Mesh/SurfaceMesh
  Mesh/MeshBridge
  Mesh/SurfaceHeat
  Mesh/ConformalFlattening
  Mesh/SurfaceRicciFlow
  IO/VolumeFiles
  IO/DicomResults
  Filtering/Heat
  Filtering/Particles
  Filtering/HeatObjects
  Filtering/ShapeSignature
  Phantom/Phantoms
  Graph/GraphModel
  Graph/EmbeddingCertificate
  Graph/RicciFlowEmbedding
  Graph/GraphComparison
  Graph/GraphCurvature
  Colon/ColonLumen
  Colon/ColonCenterline
  Colon/ColonModel
  Colon/FlatColon
  Colon/ColonLandmarks
  Colon/PolypCandidates
  Colon/SupineProne
  Colon/ColonExamination
  Bridge/ColonFilters
  Visualization/PictureKit
  Visualization/HeatViews
  Visualization/ColonViews
  Visualization/GraphViews
  Tools/CommandLine
  Tools/GraphTools
  Tools/HeatTools
  Tools/LiveSession
  Tools/ColonTools
)
