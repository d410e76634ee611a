#ifndef shapetonSurfaceLocator_h
#define shapetonSurfaceLocator_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** The point of a triangle a b c that is closest to p.
 *
 * After Ericson, Real-Time Collision Detection (2005), section 5.1.5. Also handles zero-area triangles.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT Eigen::Vector3d
                           ClosestPointOfTriangle(const Eigen::Vector3d & p,
                                                  const Eigen::Vector3d & a,
                                                  const Eigen::Vector3d & b,
                                                  const Eigen::Vector3d & c);

/** \class SurfaceLocator
 * \brief Exact closest-point queries on a surface, by a bounding box tree of its faces.
 *
 * Keeps a copy of the surface. Building is O(n log n) and multithreaded; a query is about O(log n). Queries are
 * thread-safe.
 *
 * \ingroup ShapetonSurfaceMesh
 */
class ShapetonSurfaceMesh_EXPORT SurfaceLocator
{
public:
  struct Closest
  {
    Eigen::Vector3d point;
    int             face{ -1 };
    double          distance{ 0.0 };
  };

  /** \pre There is at least one face, and all indices are in range; otherwise throws std::invalid_argument. */
  SurfaceLocator(const VertexMatrix & V, const FaceMatrix & F);
  ~SurfaceLocator();

  /** Ties go to the lowest face index, up to rounding. Throws std::invalid_argument if the position is not finite. */
  Closest
  FindClosest(const Eigen::Vector3d & p) const;

private:
  struct Node
  {
    Eigen::Vector3d low, high;
    int             begin, end; ///< its faces in m_Order
    int             right;      ///< second child; the first one follows the node; 0 for a leaf
  };

  /** Faces of a subtree, and its root node. */
  struct Part
  {
    int node, begin, end;
  };

  void
  BuildTop(const VertexMatrix & centers);
  int
  Split(const Part & part, const VertexMatrix & centers);
  int
  Build(const Part & part, const VertexMatrix & centers);
  void
  Search(int node, const Eigen::Vector3d & p, Closest & best, double & bestSquare) const;
  double
  SquareDistanceToBox(int node, const Eigen::Vector3d & p) const;

  VertexMatrix      m_V;
  FaceMatrix        m_F;
  std::vector<int>  m_Order;
  std::vector<Node> m_Nodes;
};
} // namespace shapeton

#endif
