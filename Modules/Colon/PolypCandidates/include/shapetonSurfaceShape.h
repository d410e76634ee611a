#ifndef shapetonSurfaceShape_h
#define shapetonSurfaceShape_h

#include "ShapetonPolypCandidatesExport.h"

#include "shapetonProgress.h"
#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** \class SurfaceShape
 * \brief Principal curvatures of a wall at each vertex.
 *
 * The vertex normals are diffused over the surface and renormalized; vertices are not moved. This preserves the
 * curvature of balls and cylinders at any diffusion time and removes voxel steps and noise. The shape operator of a
 * face is the least squares fit to the differences of its normals (Rusinkiewicz, Estimating curvatures and their
 * derivatives on triangle meshes, 2004); the shape operator of a vertex is the mean over its faces.
 * \ingroup ShapetonPolypCandidates */
struct SurfaceShape
{
  /** Unit vectors into the lumen. */
  VertexMatrix inwardNormals;
  /** The larger and the smaller principal curvature, 1/mm: positive where the wall bulges into the lumen. Both are 1/r
   * for a ball of radius r; the smaller one is 0 for a straight fold. */
  Eigen::VectorXd greater;
  Eigen::VectorXd lesser;
  /** Vertex areas, mm^2: a third of the area of each adjacent face. */
  Eigen::VectorXd areas;
};

/** \param F counterclockwise as seen from outside the lumen.
 * \param time of the diffusion, mm^2, at least 0; removes features with a radius below sqrt(2 time) mm. Throws the
 * InputError of MakeSurfaceLaplacian(). The result does not depend on the number of threads.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT SurfaceShape
MeasureSurfaceShape(const VertexMatrix &        V,
                    const SurfaceConnectivity & connectivity,
                    const FaceMatrix &          F,
                    double                      time,
                    const Progress &            progress = {});

/** (2/pi) atan((k1 + k2) / (k1 - k2)) in [-1, 1]: 1 for a cap in the lumen, 0.5 for a ridge, 0 for a saddle, -1 for a
 * pit (Koenderink and van Doorn, Surface shape and curvature scales, 1992, with this sign; Yoshida and Nappi, IEEE TMI
 * 20, 2001, map it to [0, 1]). \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
ShapeIndex(double greater, double lesser);

/** sqrt((k1^2 + k2^2) / 2), 1/mm. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
Curvedness(double greater, double lesser);
} // namespace shapeton

#endif
