#ifndef shapetonColonWallTube_h
#define shapetonColonWallTube_h

#include "ColonLandmarksExport.h"

#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonSurfaceConnectivity.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** \class ColonWallTube
 * \brief The wall of a flat colon without its cut: what walks over the wall are made on.
 *
 * Vertices of the flat surface at one place (sourcePointId) are one vertex here; faces keep their order. A walk may
 * cross the cut: Turns() counts how often an edge does, so that a walk around the tube is told from one that is not.
 *
 * \ingroup ColonLandmarks */
class ColonLandmarks_EXPORT ColonWallTube
{
public:
  /** \param centreline one curve with arcLength, from the rectum to the caecum of this surface.
   * Throws InputError, with the reason, where an array is missing, or the centreline belongs to another colon or runs
   * the other way. One that covers a part of the surface is taken, with a warning. */
  ColonWallTube(const FlatColon & colon, const CurveSet & centreline);
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
  /** Of a vertex of the flat surface. */
  int
  VertexOfFlat(int flatVertex) const
  {
    return m_VertexOfFlat[flatVertex];
  }
  /** One vertex of the flat surface at this place. */
  int
  FlatOfVertex(int vertex) const
  {
    return m_FlatOfVertex[vertex];
  }
  /** Whether the cut of the flat surface runs through the vertex. */
  bool
  IsOnCut(int vertex) const
  {
    return m_IsOnCut[vertex] != 0;
  }
  /** mm; v is that of FlatOfVertex(). */
  Eigen::Vector2d
  Uv(int vertex) const
  {
    return m_Uv.row(vertex).transpose();
  }
  /** mm along the centreline. */
  double
  ArcLength(int vertex) const
  {
    return m_ArcLength[vertex];
  }
  /** mm along the centreline of the middle of the tube at this u (mm of the map). Never falling. */
  double
  ArcLengthOfU(double u) const;
  double
  Circumference() const
  {
    return m_Circumference;
  }
  /** By how many turns, towards larger v, one has gone around the tube from vertex a to its neighbour b, over and above
   * the difference of their v. */
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
  MeasureArcLength(const FlatColon & colon, const CurveSet & centreline);

  VertexMatrix                         m_V;
  FaceMatrix                           m_F;
  std::unique_ptr<SurfaceConnectivity> m_Connectivity;
  std::vector<int>                     m_VertexOfFlat;
  std::vector<int>                     m_FlatOfVertex;
  std::vector<char>                    m_IsOnCut;
  std::vector<int>                     m_TurnsOfEdge; ///< from the lesser to the greater vertex
  Eigen::MatrixX2d                     m_Uv;
  Eigen::VectorXd                      m_ArcLength;
  std::vector<double>                  m_ArcLengthOfColumn;
  double                               m_ColumnWidth{ 1.0 };
  double                               m_Circumference{ 1.0 };
  std::vector<std::string>             m_Warnings;
};

/** \class SurfaceWalk
 * \brief A list of neighbouring vertices of a tube. \ingroup ColonLandmarks */
struct SurfaceWalk
{
  /** Of the tube. A closed walk does not repeat its first vertex. */
  std::vector<int> vertices;
  /** mm. */
  double length{ 0.0 };
};
} // namespace shapeton

#endif
