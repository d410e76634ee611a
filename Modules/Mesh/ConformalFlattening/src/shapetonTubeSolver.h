#ifndef shapetonTubeSolver_h
#define shapetonTubeSolver_h

#include "shapetonConformalTube.h"

#include <memory>

namespace shapeton
{
/** \class TubeSolver
 * \brief Repeatable FlattenTube() with different edge weights.
 *
 * The moduli are computed in the metric for any weights: modulusU remains an upper and modulusV a lower bound. */
class TubeSolver
{
public:
  /** Same arguments as FlattenTube(), held by reference. */
  TubeSolver(const SurfaceMesh &         mesh,
             const SurfaceConnectivity & connectivity,
             const Eigen::VectorXd &     edgeLengths,
             const TubeEnds &            ends,
             const TubeOptions &         options);
  ~TubeSolver();

  /** Progress covers this map alone. */
  TubeMap
  Solve(const Progress & progress);

  /** Sets the weights to BoundedWeights() of these vertex levels. */
  void
  BoundWeights(const std::vector<int> & levels);

private:
  class Flattening;

  std::unique_ptr<Flattening> m_Flattening;
};
} // namespace shapeton

#endif
