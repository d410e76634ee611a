#ifndef shapetonDevelopment_h
#define shapetonDevelopment_h

#include "shapetonIntrinsicTriangulation.h"
#include "shapetonRicciFlowWords.h"

#include <complex>

namespace shapeton
{
/** A point of the plane or of the Poincare disk. */
using PlanePoint = std::complex<double>;

double
DistanceInPlane(RicciGeometry geometry, PlanePoint a, PlanePoint b);

/** Whether a, b, c are counterclockwise, with an area above rounding errors. */
bool
IsCounterclockwise(RicciGeometry geometry, PlanePoint a, PlanePoint b, PlanePoint c);

/** The image of z under the orientation-preserving isometry that maps a to `toA` and b to `toB`. */
PlanePoint
Carried(RicciGeometry geometry, PlanePoint a, PlanePoint b, PlanePoint toA, PlanePoint toB, PlanePoint z);

/** Places of the corners of each face in its own chart, by sides. */
std::vector<PlanePoint>
ChartsOfFaces(const IntrinsicTriangulation & triangulation, const Eigen::VectorXd & lengths, RicciGeometry geometry);

/** Undoes flips in reverse order and moves the places along: each quadrilateral is developed in the chart of one of its
 * faces, where both diagonals are straight. In a nonconvex quadrilateral, a diagonal outside yields a face with the
 * opposite orientation. */
void
UndoFlips(const std::vector<int> &  flips,
          RicciGeometry             geometry,
          IntrinsicTriangulation &  triangulation,
          std::vector<PlanePoint> & charts);

/** Develops the faces around the face `root` without crossing cut edges; one place for each side. */
std::vector<PlanePoint>
LayOutFaces(const IntrinsicTriangulation &  triangulation,
            const std::vector<PlanePoint> & charts,
            const std::vector<char> &       isCut,
            RicciGeometry                   geometry,
            int                             root);

/** A face far from cut edges and boundaries. */
int
InnermostFace(const IntrinsicTriangulation & triangulation, const std::vector<char> & isCut);

/** Half of a double: faces and their side lengths. */
struct GeodesicFaces
{
  FaceMatrix                                                F;
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> sides;
};

/** The faces of a triangulation with their side lengths. */
GeodesicFaces
FacesOf(const IntrinsicTriangulation & triangulation, const Eigen::VectorXd & lengths);

/** The half of a symmetric double with the vertices of side 1, after flipping edges that cross the axis.
 * \param sideOfVertices 1 and 2 for the copies, 0 on the axis.
 * \param axis pairs of vertices of the axis edges and their lengths. */
GeodesicFaces
HalfOfDouble(IntrinsicTriangulation                                     triangulation,
             std::vector<PlanePoint>                                    charts,
             const std::vector<char> &                                  sideOfVertices,
             const std::vector<std::pair<std::array<int, 2>, double>> & axis,
             RicciGeometry                                              geometry);
} // namespace shapeton

#endif
