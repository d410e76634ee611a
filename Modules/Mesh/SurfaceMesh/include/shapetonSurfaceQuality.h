#ifndef shapetonSurfaceQuality_h
#define shapetonSurfaceQuality_h

#include "shapetonJsonForward.h"
#include "shapetonSurfaceConnectivity.h"

#include <array>

namespace shapeton
{
/** Defects of a surface, as ascending indices. RepairSurface() repairs all except zeroAreaFaces.
 * \ingroup ShapetonSurfaceMesh
 */
struct SurfaceDefects
{
  /** Faces with a repeated vertex. */
  std::vector<int> degenerateFaces;
  /** Other faces with a height below 1e-12 of their longest side. */
  std::vector<int> zeroAreaFaces;
  /** Faces with the vertices of an earlier one, in any order. */
  std::vector<int> duplicateFaces;
  /** Vertices not used by any face. */
  std::vector<int> unreferencedVertices;
  /** Vertices at the position of an earlier one, within 1e-9 of the largest extent. */
  std::vector<int> coincidentVertices;
  /** Edges (of SurfaceConnectivity) with more than two faces. */
  std::vector<int> nonManifoldEdges;
  /** Vertices with more than one fan of faces, or at a non-manifold edge. */
  std::vector<int> nonManifoldVertices;
  /** Edges with two faces in the same direction. */
  std::vector<int> inconsistentEdges;

  /** No defects, except for coincident vertices, because components may touch. */
  ShapetonSurfaceMesh_EXPORT bool
  AreNone() const;
};

/** Finds the defective faces, edges and vertices of a surface. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceDefects
FindSurfaceDefects(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity);

/** Order statistics, by linear interpolation between neighboring values. \ingroup ShapetonSurfaceMesh */
struct SurfaceStatistics
{
  double minimum{ 0.0 };
  double percentile1{ 0.0 };
  double median{ 0.0 };
  double percentile99{ 0.0 };
  double maximum{ 0.0 };
};

/** Minimum, percentiles and maximum; zeros for an empty list. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceStatistics
StatisticsOf(std::vector<double> values);

/** Statistics of a surface. Lengths in mm, areas in mm^2, volumes in mm^3, angles in degrees.
 * \ingroup ShapetonSurfaceMesh */
struct SurfaceQuality
{
  int vertices{ 0 };
  int edges{ 0 };
  int faces{ 0 };
  /** Referenced vertices - edges + faces. */
  int                           eulerCharacteristic{ 0 };
  std::vector<SurfaceComponent> components;
  /** Length of each boundary loop, in the order of SurfaceConnectivity::BoundaryLoops(). */
  std::vector<double> boundaryLoopLengths;
  std::vector<int>    boundaryLoopVertices;
  bool                isManifold{ false };
  bool                isClosed{ false };
  bool                isOriented{ false };
  /** Sum over the components; not set if any component has none. */
  std::optional<int> genus;
  double             area{ 0.0 };
  /** Enclosed volume; not set unless the surface is closed, manifold and oriented. Negative if the faces point inward.
   */
  std::optional<double> volume;
  Eigen::Vector3d       lowestCorner{ Eigen::Vector3d::Zero() };
  Eigen::Vector3d       highestCorner{ Eigen::Vector3d::Zero() };
  SurfaceStatistics     edgeLength;
  /** Smallest angle of each face. */
  SurfaceStatistics smallestAngle;
  /** Largest angle of each face. */
  SurfaceStatistics largestAngle;
  /** Longest side over 2 sqrt(3) inscribed radii: 1 for an equilateral triangle. Zero-area faces are skipped. */
  SurfaceStatistics aspectRatio;
  SurfaceDefects    defects;
  /** Ends of SurfaceDefects::nonManifoldEdges. */
  std::vector<std::array<Eigen::Vector3d, 2>> nonManifoldEdges;
  /** The components that RepairSurface() returns, which tools compute with; empty if there are neither coincident nor
   * non-manifold vertices, because the repair then keeps the topology. */
  std::vector<SurfaceComponent> componentsAfterRepair;
};

/** Computes the statistics of a surface in linear time and memory. Throws InputError as RequireSound() does.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceQuality
InspectSurface(const SurfaceMesh & mesh);

/** Total area of the faces (mm^2). \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT double
SurfaceArea(const VertexMatrix & V, const FaceMatrix & F);

/** Unit normals of the vertices, weighted by the areas of their faces; zero for a vertex whose faces have no area.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT VertexMatrix
VertexNormals(const VertexMatrix & V, const FaceMatrix & F);

/** Volume enclosed by a closed oriented surface (mm^3, divergence theorem); negative if its faces point inward.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT double
EnclosedVolume(const VertexMatrix & V, const FaceMatrix & F);

/** Quality as JSON. The keys are stable: vertices, edges, faces, eulerCharacteristic, genus (null: not defined),
 * manifold, closed, oriented, area, volume (null), extent, lowestCorner, highestCorner, components (a list of faces,
 * vertices, edges, boundaryLoops, eulerCharacteristic, manifold, orientable, genus), boundaryLoops (a list of
 * vertices, length), edgeLength, smallestAngle, largestAngle, aspectRatio (minimum, percentile1, median, percentile99,
 * maximum), defects (counts: degenerateFaces, zeroAreaFaces, duplicateFaces, unreferencedVertices, coincidentVertices,
 * nonManifoldEdges, nonManifoldVertices, inconsistentEdges), nonManifoldEdges (a list of at most ten, each with the
 * coordinates of both ends), componentsAfterRepair (a list like components; null if equal to it). Numbers are rounded
 * to 9 significant digits. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT Json
SurfaceQualityToJson(const SurfaceQuality & quality);

/** Quality as human-readable text; long lists are cut after ten items. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT std::string
                           FormatSurfaceQuality(const SurfaceQuality & quality);
} // namespace shapeton

#endif
