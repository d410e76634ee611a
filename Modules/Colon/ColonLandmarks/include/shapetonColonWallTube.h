#ifndef shapetonColonWallTube_h
#define shapetonColonWallTube_h

#include "ShapetonColonLandmarksExport.h"

#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonSurfaceConnectivity.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** \class ColonWallTube
 * \brief The wall of a flat colon with the cut closed, for path searches.
 *
 * Duplicate vertices of the flat surface (equal sourcePointId) are merged; the order of faces is unchanged. A walk may
 * cross the cut. Turns() counts how often an edge crosses the cut; the sum over a walk shows whether it goes around the
 * tube.
 *
 * \ingroup ShapetonColonLandmarks */
class ShapetonColonLandmarks_EXPORT ColonWallTube
{
public:
  /** \param centerline one curve with arcLength, from the rectum to the cecum of this surface.
   * Throws InputError if an array is missing, or the centerline does not match the surface or is reversed. Warns if the
   * centerline covers only part of the surface. */
  ColonWallTube(const FlatColon & colon, const CurveSet & centerline);
  ~ColonWallTube();

  const VertexMatrix &
  Points() const
  {
    return m_V;
  }
  const FaceMatrix &
  Faces() const
  {
    return m_F;
  }
  const SurfaceConnectivity &
  Connectivity() const
  {
    return *m_Connectivity;
  }
  int
  NumberOfVertices() const
  {
    return static_cast<int>(m_V.rows());
  }
  /** The tube vertex that corresponds to a vertex of the flat surface. */
  int
  VertexOfFlat(int flatVertex) const
  {
    return m_VertexOfFlat[flatVertex];
  }
  /** One of the vertices of the flat surface that were merged into this vertex. */
  int
  FlatOfVertex(int vertex) const
  {
    return m_FlatOfVertex[vertex];
  }
  /** Whether the vertex is on the cut of the flat surface. */
  bool
  IsOnCut(int vertex) const
  {
    return m_IsOnCut[vertex] != 0;
  }
  /** Position of FlatOfVertex() on the map, mm. */
  Eigen::Vector2d
  Uv(int vertex) const
  {
    return m_Uv.row(vertex).transpose();
  }
  /** Distance along the centerline, mm. */
  double
  ArcLength(int vertex) const
  {
    return m_ArcLength[vertex];
  }
  /** Distance along the centerline (mm) of the tube center at u (mm of the map); nondecreasing. */
  double
  ArcLengthOfU(double u) const;
  double
  Circumference() const
  {
    return m_Circumference;
  }
  /** Number of turns to add to the difference in v between vertex a and its neighbor b; positive toward larger v. */
  int
  Turns(int a, int b) const;

  const std::vector<std::string> &
  Warnings() const
  {
    return m_Warnings;
  }

private:
  void
  Weld(const SurfaceMesh & flat);
  void
  CountTurns(const SurfaceMesh & flat, const Eigen::MatrixX2d & uv);
  void
  MeasureArcLength(const FlatColon & colon, const CurveSet & centerline);

  VertexMatrix                         m_V;
  FaceMatrix                           m_F;
  std::unique_ptr<SurfaceConnectivity> m_Connectivity;
  std::vector<int>                     m_VertexOfFlat;
  std::vector<int>                     m_FlatOfVertex;
  std::vector<char>                    m_IsOnCut;
  std::vector<int>                     m_TurnsOfEdge; ///< from the lower to the higher vertex index
  Eigen::MatrixX2d                     m_Uv;
  Eigen::VectorXd                      m_ArcLength;
  std::vector<double>                  m_ArcLengthOfColumn;
  double                               m_ColumnWidth{ 1.0 };
  double                               m_Circumference{ 1.0 };
  std::vector<std::string>             m_Warnings;
};

/** \class SurfaceWalk
 * \brief A sequence of neighboring vertices of a tube. \ingroup ShapetonColonLandmarks */
struct SurfaceWalk
{
  /** Vertices of the tube; a closed walk does not repeat the first vertex. */
  std::vector<int> vertices;
  /** Length, mm. */
  double length{ 0.0 };
};
} // namespace shapeton

#endif
