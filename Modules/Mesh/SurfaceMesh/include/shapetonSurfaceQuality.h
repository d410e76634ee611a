#ifndef shapetonSurfaceQuality_h
#define shapetonSurfaceQuality_h

#include "shapetonJsonForward.h"
#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** What is wrong with a surface: indices, in ascending order. RepairSurface() mends all but zeroAreaFaces.
 * \ingroup SurfaceMesh */
struct SurfaceDefects
{
  /** Faces that name a vertex twice. */
  std::vector<int> degenerateFaces;
  /** Other faces whose height is below 1e-12 of their longest side. */
  std::vector<int> zeroAreaFaces;
  /** Faces with the vertices of an earlier one, in any order. */
  std::vector<int> duplicateFaces;
  /** Vertices that no face names. */
  std::vector<int> unreferencedVertices;
  /** Vertices at exactly the position of an earlier one. */
  std::vector<int> coincidentVertices;
  /** Edges (of SurfaceConnectivity) with more than two faces. */
  std::vector<int> nonManifoldEdges;
  /** Vertices with more than one fan of faces, or at a non-manifold edge. */
  std::vector<int> nonManifoldVertices;
  /** Edges along which two faces run in the same direction. */
  std::vector<int> inconsistentEdges;

  /** Nothing but, perhaps, coincident vertices: two components may touch. */
  SurfaceMesh_EXPORT bool
  AreNone() const;
};

/** The faces, edges and vertices that keep a surface from being a proper mesh. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceDefects
FindSurfaceDefects(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity);

/** Order statistics, by linear interpolation between the two nearest values. \ingroup SurfaceMesh */
struct SurfaceStatistics
{
  double minimum{ 0.0 };
  double percentile1{ 0.0 };
  double median{ 0.0 };
  double percentile99{ 0.0 };
  double maximum{ 0.0 };
};

/** The minimum, percentiles and maximum of some values; zeros for none. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceStatistics
StatisticsOf(std::vector<double> values);

/** What a surface is like. Lengths in mm, areas in mm^2, volumes in mm^3, angles in degrees. \ingroup SurfaceMesh */
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
  /** The sum over the components; nothing where one of them has none. */
  std::optional<int> genus;
  double             area{ 0.0 };
  /** Enclosed volume; nothing where the surface is not closed, manifold and oriented. Negative where the faces look
   * inwards. */
  std::optional<double> volume;
  Eigen::Vector3d       lowestCorner{ Eigen::Vector3d::Zero() };
  Eigen::Vector3d       highestCorner{ Eigen::Vector3d::Zero() };
  SurfaceStatistics     edgeLength;
  /** Of the smallest angle of each face. */
  SurfaceStatistics smallestAngle;
  /** Of the largest angle of each face. */
  SurfaceStatistics largestAngle;
  /** Longest side over 2 sqrt(3) inscribed radii: 1 for an equilateral triangle. Faces without area are left out. */
  SurfaceStatistics aspectRatio;
  SurfaceDefects    defects;
};

/** Inspects a surface. Time and memory grow in proportion to its faces. Throws InputError as RequireSound() does.
 * \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceQuality
InspectSurface(const SurfaceMesh & mesh);

/** The sum of the areas of the faces in mm^2. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT double
SurfaceArea(const VertexMatrix & V, const FaceMatrix & F);

/** The volume in mm^3 that a closed oriented surface encloses (divergence theorem); negative where its faces look
 * inwards. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT double
EnclosedVolume(const VertexMatrix & V, const FaceMatrix & F);

/** The quality for programs. Keys, whose names stay: vertices, edges, faces, eulerCharacteristic, genus (null: not
 * defined), manifold, closed, oriented, area, volume (null), extent, lowestCorner, highestCorner, components (a list of
 * faces, vertices, edges, boundaryLoops, eulerCharacteristic, manifold, orientable, genus), boundaryLoops (a list of
 * vertices, length), edgeLength, smallestAngle, largestAngle, aspectRatio (minimum, percentile1, median, percentile99,
 * maximum), defects (how many: degenerateFaces, zeroAreaFaces, duplicateFaces, unreferencedVertices,
 * coincidentVertices, nonManifoldEdges, nonManifoldVertices, inconsistentEdges). Numbers are rounded to 9 significant
 * digits.
 * \ingroup SurfaceMesh */
SurfaceMesh_EXPORT Json
SurfaceQualityToJson(const SurfaceQuality & quality);

/** The quality for people, some lines; long lists are cut after ten. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT std::string
                   FormatSurfaceQuality(const SurfaceQuality & quality);
} // namespace shapeton

#endif
