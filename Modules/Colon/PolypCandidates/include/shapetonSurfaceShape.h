#ifndef shapetonSurfaceShape_h
#define shapetonSurfaceShape_h

#include "PolypCandidatesExport.h"

#include "shapetonProgress.h"
#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** \class SurfaceShape
 * \brief How a wall is curved at each vertex.
 *
 * The normals of the vertices are diffused over the surface and made unit vectors again; the surface itself is not
 * moved. So balls and cylinders keep their curvature whatever the time of the diffusion, while steps of voxels and
 * noise go. The shape operator of each face is the least squares fit to the differences of its normals (Rusinkiewicz,
 * Estimating curvatures and their derivatives on triangle meshes, 2004), that of a vertex the mean over its faces.
 * \ingroup PolypCandidates */
struct SurfaceShape
{
  /** Unit vectors into the lumen. */
  VertexMatrix inwardNormals;
  /** The greater and the lesser principal curvature, 1/mm: positive where the wall bulges into the lumen. A ball of
   * radius r that lies in the lumen has 1/r for both, a straight fold 0 for the lesser one. */
  Eigen::VectorXd greater;
  Eigen::VectorXd lesser;
  /** mm^2; a third of each face. */
  Eigen::VectorXd areas;
};

/** \param F counterclockwise where seen from outside of the lumen.
 * \param time of the diffusion, mm^2, from 0: features of radius below sqrt(2 time) mm are lost.
 * Throws InputError as MakeSurfaceLaplacian() does. The same bytes for any number of threads.
 * \ingroup PolypCandidates */
PolypCandidates_EXPORT SurfaceShape
MeasureSurfaceShape(const VertexMatrix &        V,
                    const SurfaceConnectivity & connectivity,
                    const FaceMatrix &          F,
                    double                      time,
                    const Progress &            progress = {});

/** (2/pi) atan((k1 + k2) / (k1 - k2)) in [-1, 1]: 1 a cap in the lumen, 0.5 a ridge, 0 a saddle, -1 a pit (Koenderink
 * and van Doorn, Surface shape and curvature scales, 1992, with this sign; Yoshida and Nappi, IEEE TMI 20, 2001, map
 * it to [0, 1]). \ingroup PolypCandidates */
PolypCandidates_EXPORT double
ShapeIndex(double greater, double lesser);

/** sqrt((k1^2 + k2^2) / 2), 1/mm. \ingroup PolypCandidates */
PolypCandidates_EXPORT double
Curvedness(double greater, double lesser);
} // namespace shapeton

#endif
