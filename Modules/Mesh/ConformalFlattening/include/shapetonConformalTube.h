#ifndef shapetonConformalTube_h
#define shapetonConformalTube_h

#include "shapetonFlatSurface.h"
#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"
#include "shapetonTubeEnds.h"

namespace shapeton
{
/** How the second coordinate of a tube is computed. \ingroup ConformalFlattening */
enum class TubeConjugate
{
  /** A second Laplacian with a unit jump across the cut and natural boundaries. */
  Laplacian,
  /** As published: the Hodge star of du in each face, averaged over the faces of each edge, is summed along a tree of
   * edges. Handles make the sum depend on the tree. */
  Published
};

/** Conjugate function and cut for FlattenTube(). \ingroup ConformalFlattening */
struct TubeOptions
{
  TubeConjugate conjugate{ TubeConjugate::Laplacian };
  /** A curve near which the tube is cut, such as a taenia; LPS, mm. Empty: a path is found. */
  std::vector<Eigen::Vector3d> cutCurve;
  /** Edges within so many rings of a saddle of u cost saddleCost times their length: that is where handles are. */
  int    saddleRings{ 3 };
  double saddleCost{ 1000.0 };
  /** It may throw in order to abort. */
  Progress progress;
};

/** A tube as a rectangle. \ingroup ConformalFlattening */
struct TubeMap
{
  /** A flat surface with `circumference` and `length`. */
  SurfaceMesh flat;
  /** For each vertex of the tube, 0 on its first loop and 1 on the second: harmonic. */
  Eigen::VectorXd u;
  /** The vertices of the tube along which it was cut, from the first loop to the second. */
  std::vector<int> cutPath;
  /** \name Circumference over length of the rectangle that is conformally equivalent
   * modulusU = E(u), the integral of |grad u|^2, is not less than the true one; modulusV = 1 / E(v), with v of period
   * 1, is not greater (Dirichlet's principle), if there are no handles: their gap is the error bar. For the published
   * route modulusV is the mean period of the summed v. */
  ///@{
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
  /** modulusU / modulusV - 1. */
  double
  Gap() const
  {
    return modulusU / modulusV - 1.0;
  }
  ///@}
  double circumference{ 0.0 }; ///< mm
  double length{ 0.0 };        ///< mm
  /** Critical points of u with their multiplicity, two for each handle at least; none on an ideal tube. */
  int saddles{ 0 };
};

/** Maps a tube to the plane, conformally in the metric of these lengths of edges (dissertation 5.3).
 *
 * u is harmonic, 0 and 1 on the loops; a path from loop to loop that avoids handles is the cut; v is the harmonic
 * function that grows by 1 around the tube and has natural boundaries. uv = (length u, circumference v), circumference
 * as in \ref FlatSurface and length = circumference / sqrt(modulusU modulusV), which makes the map as conformal as it
 * can be. Seen from inside with u to the right, v points up.
 *
 * The surface has to be cut along edges, so v leaves [0, circumference] by as much as the cut deviates from a line of
 * v = 0, and a point (u, v) is also a point (u, v + circumference). The path found is a shortest one, laid a second
 * time along v = 0 when v is known. It keeps away from handles.
 *
 * \param edgeLengths in the order of the edges of the connectivity, in any metric and unit.
 * \pre The surface is a tube: FindTubeEnds(). Throws InputError as MakeSurfaceLaplacian() does, and where the cut curve
 * is far from the surface. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT TubeMap
FlattenTube(const SurfaceMesh &         mesh,
            const SurfaceConnectivity & connectivity,
            const Eigen::VectorXd &     edgeLengths,
            const TubeEnds &            ends,
            const TubeOptions &         options = {});

/** The harmonic function with 0 on the first loop and 1 on the second. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT Eigen::VectorXd
HarmonicAlongTube(const SurfaceLaplacian & laplacian, const TubeEnds & ends, const Progress & progress = {});

/** The mean length of the level sets of u, 0 <= u <= 1, on the surface in space: the integral of |grad u|; mm.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT double
MeanLevelLength(const SurfaceMesh & mesh, const Eigen::VectorXd & u);

/** The lengths of the level sets u = (i + 1/2) / number, i = 0, 1, ...; mm. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT Eigen::VectorXd
                           LevelLengths(const SurfaceMesh & mesh, const Eigen::VectorXd & u, int number);

/** The least of 500 level lengths over 2 pi, mm: the radius for DefaultDiffusionTime(). It is the way around the tube
 * along its folds that diffusion takes; the greatest ball inside is smaller. Levels through faces with the cell array
 * `bridged` are left out, as those are synthetic; all count where none is left. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT double
NarrowestLevelRadius(const SurfaceMesh & mesh, const Eigen::VectorXd & u);
} // namespace shapeton

#endif
