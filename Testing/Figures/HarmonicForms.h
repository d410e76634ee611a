#ifndef HarmonicForms_h
#define HarmonicForms_h

#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceLaplacian.h"

/** The conventional basis that section 5.3.1 of the dissertation compares with its own method (Gu and Yau, Global
 * conformal surface parameterization, 2003): a harmonic 1-form for each of the 2g homology classes of the handles, each
 * from one Poisson equation. */
struct HarmonicForms
{
  /** One column per class: the form on each edge from its lower to its higher vertex. */
  Eigen::MatrixXd forms;
};

/** Largest sum around a face, and largest divergence at a vertex, relative to the largest value: 0 for harmonic forms.
 */
struct HarmonicErrors
{
  double closure{ 0.0 };
  double divergence{ 0.0 };
};

/** \pre One oriented manifold component with at least one boundary. */
HarmonicForms
FindHarmonicForms(const shapeton::SurfaceMesh &         mesh,
                  const shapeton::SurfaceConnectivity & connectivity,
                  const shapeton::SurfaceLaplacian &    laplacian);

HarmonicErrors
ErrorsOf(const HarmonicForms &                 forms,
         const shapeton::SurfaceMesh &         mesh,
         const shapeton::SurfaceConnectivity & connectivity,
         const shapeton::SurfaceLaplacian &    laplacian);

#endif
