#ifndef shapetonSurfaceLocator_h
#define shapetonSurfaceLocator_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** The point of a triangle a b c that is closest to p.
 *
 * After Ericson, Real-Time Collision Detection (2005), section 5.1.5. Works for triangles without area, too.
 * \ingroup SurfaceMesh */
SurfaceMesh_EXPORT Eigen::Vector3d
                   ClosestPointOfTriangle(const Eigen::Vector3d & p,
                                          const Eigen::Vector3d & a,
                                          const Eigen::Vector3d & b,
                                          const Eigen::Vector3d & c);

/** \class SurfaceLocator
 * \brief Closest points on a surface, exact, by a tree of boxes around its faces.
 *
 * Keeps a copy of the surface. Building takes n log n, on several threads, a question about log n. A question may be
 * asked from any number of threads at once.
 *
 * \ingroup SurfaceMesh
 */
class SurfaceMesh_EXPORT SurfaceLocator
{
public:
  struct Closest
  {
    Eigen::Vector3d point;
    int             face{ -1 };
    double          distance{ 0.0 };
  };

  /** \pre There is a face, and all indices are in range; else std::invalid_argument. */
  SurfaceLocator(const VertexMatrix & V, const FaceMatrix & F);
  ~SurfaceLocator();

  /** Of several equally close faces the one with the least index, up to rounding. Throws std::invalid_argument for a
   * place that is not finite. */
  Closest
  FindClosest(const Eigen::Vector3d & p) const;

private:
  struct Node
  {
    Eigen::Vector3d low, high;
    int             begin, end; ///< its faces in m_Order
    int             right;      ///< the second child; the first one follows the node; 0 for a leaf
  };

  /** Faces that make a subtree, and its first node. */
  struct Part
  {
    int node, begin, end;
  };

  void
  BuildTop(const VertexMatrix & centres);
  int
  Split(const Part & part, const VertexMatrix & centres);
  int
  Build(const Part & part, const VertexMatrix & centres);
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
