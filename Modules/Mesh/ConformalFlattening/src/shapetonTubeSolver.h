#ifndef shapetonTubeSolver_h
#define shapetonTubeSolver_h

#include "shapetonConformalTube.h"

#include <memory>

namespace shapeton
{
/** \class TubeSolver
 * \brief FlattenTube() as often as one likes, with other weights of the edges each time.
 *
 * The moduli are those of the metric whatever the weights: modulusU stays an upper and modulusV a lower bound. */
class TubeSolver
{
public:
  /** The arguments are those of FlattenTube() and are referred to. */
  TubeSolver(const SurfaceMesh &         mesh,
             const SurfaceConnectivity & connectivity,
             const Eigen::VectorXd &     edgeLengths,
             const TubeEnds &            ends,
             const TubeOptions &         options);
  ~TubeSolver();

  /** Progress is told of this map alone. */
  TubeMap
  Solve(const Progress & progress);

  /** From now on the weights are BoundedWeights() of these levels of the vertices. */
  void
  BoundWeights(const std::vector<int> & levels);

private:
  class Flattening;

  std::unique_ptr<Flattening> m_Flattening;
};
} // namespace shapeton

#endif
