#ifndef shapetonConformalTube_h
#define shapetonConformalTube_h

#include "shapetonFlatSurface.h"
#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"
#include "shapetonTubeEnds.h"

namespace shapeton
{
/** Method for the second coordinate of a tube. \ingroup ShapetonConformalFlattening */
enum class TubeConjugate
{
  /** A second harmonic function, with a unit jump across the cut and natural boundaries. */
  Laplacian,
  /** As published: the Hodge star of du in each face, averaged over the faces of each edge and summed along an edge
   * tree. With handles the sum depends on the tree. */
  Published
};

/** Conjugate function and cut for FlattenTube(). \ingroup ShapetonConformalFlattening */
struct TubeOptions
{
  TubeConjugate conjugate{ TubeConjugate::Laplacian };
  /** Curve near which to cut the tube, such as a taenia (LPS, mm). Empty: a path is computed. */
  std::vector<Eigen::Vector3d> cutCurve;
  /** Within this many rings of a saddle of u, edges cost saddleCost times their length, because saddles mark handles.
   */
  int    saddleRings{ 3 };
  double saddleCost{ 1000.0 };
  /** May throw to abort. */
  Progress progress;
};

/** A tube as a rectangle. \ingroup ShapetonConformalFlattening */
struct TubeMap
{
  /** A flat surface with `circumference` and `length`. */
  SurfaceMesh flat;
  /** Harmonic coordinate of each tube vertex: 0 on the first loop, 1 on the second. */
  Eigen::VectorXd u;
  /** Tube vertices along the cut, from the first loop to the second. */
  std::vector<int> cutPath;
  /** \name Circumference over length of the conformally equivalent rectangle
   * Without handles, modulusU = E(u), the integral of |grad u|^2, is an upper bound of the true modulus, and modulusV
   * = 1 / E(v), with v of period 1, a lower bound (Dirichlet's principle). The gap between them bounds the error. For
   * the published method modulusV is the mean period of the summed v. */
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
  /** Critical points of u with multiplicity: at least two per handle, none on an ideal tube. */
  int saddles{ 0 };
};

/** Maps a tube to the plane, conformally in the metric given by the edge lengths (dissertation 5.3).
 *
 * u is harmonic, 0 and 1 on the loops. The cut is a path from loop to loop that avoids handles. v is the harmonic
 * function that grows by 1 around the tube, with natural boundaries. uv = (length u, circumference v), with the
 * circumference of \ref FlatSurface and length = circumference / sqrt(modulusU modulusV), which minimizes conformal
 * distortion. Seen from inside with u to the right, v points up.
 *
 * The cut follows edges, so v leaves [0, circumference] by the deviation of the cut from the line v = 0; the points (u,
 * v) and (u, v + circumference) are equivalent. The computed path is a shortest path that avoids handles, recomputed
 * along v = 0 once v is known.
 *
 * \param edgeLengths in the edge order of the connectivity, in any metric and unit.
 * \pre The surface is a tube: FindTubeEnds(). Throws InputError as MakeSurfaceLaplacian() does, and if the cut curve is
 * far from the surface. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT TubeMap
FlattenTube(const SurfaceMesh &         mesh,
            const SurfaceConnectivity & connectivity,
            const Eigen::VectorXd &     edgeLengths,
            const TubeEnds &            ends,
            const TubeOptions &         options = {});

/** The harmonic function that is 0 on the first loop and 1 on the second. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT Eigen::VectorXd
HarmonicAlongTube(const SurfaceLaplacian & laplacian, const TubeEnds & ends, const Progress & progress = {});

/** Mean length of the level sets of u, 0 <= u <= 1, on the surface in space: the integral of |grad u| (mm).
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT double
MeanLevelLength(const SurfaceMesh & mesh, const Eigen::VectorXd & u);

/** Lengths (mm) of the level sets u = (i + 1/2) / number, i = 0, 1, ... \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT Eigen::VectorXd
                                   LevelLengths(const SurfaceMesh & mesh, const Eigen::VectorXd & u, int number);

/** The smallest of 500 level lengths divided by 2 pi (mm): the radius for DefaultDiffusionTime(). It measures the
 * circumference along the folds, as diffusion does; the largest inscribed ball is smaller. Levels through faces with
 * the cell array `bridged` are skipped because those faces are synthetic; if no level remains, all are used.
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT double
NarrowestLevelRadius(const SurfaceMesh & mesh, const Eigen::VectorXd & u);
} // namespace shapeton

#endif
