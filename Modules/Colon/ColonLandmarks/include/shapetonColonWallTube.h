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
 * \brief The wall of a flat colon without its cut, on which walks are computed.
 *
 * Vertices of the flat surface at one place (sourcePointId) are one vertex here; faces keep their order. A walk may
 * cross the cut; Turns() counts the crossings of an edge and so identifies walks around the tube.
 *
 * \ingroup ShapetonColonLandmarks */
class ShapetonColonLandmarks_EXPORT ColonWallTube
{
public:
  /** \param centerline one curve with arcLength, from the rectum to the cecum of this surface.
   * Throws InputError, with the reason, when an array is missing, or the centerline belongs to another colon or runs in
   * the opposite direction. A centerline that covers only part of the surface gives a warning. */
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
  /** The tube vertex of a vertex of the flat surface. */
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
  /** Position on the map, mm; v is that of FlatOfVertex(). */
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
  /** Distance along the centerline (mm) of the middle of the tube at this u (mm of the map); nondecreasing. */
  double
  ArcLengthOfU(double u) const;
  double
  Circumference() const
  {
    return m_Circumference;
  }
  /** Number of turns around the tube, positive toward larger v, from vertex a to its neighbor b, in addition to the
   * difference of their v. */
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
  /** Vertices of the tube. A closed walk does not repeat its first vertex. */
  std::vector<int> vertices;
  /** Length, mm. */
  double length{ 0.0 };
};
} // namespace shapeton

#endif
