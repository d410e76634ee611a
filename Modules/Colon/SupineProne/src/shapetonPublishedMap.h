#ifndef shapetonPublishedMap_h
#define shapetonPublishedMap_h

#include "shapetonColonPair.h"
#include "shapetonCylinderMap.h"
#include "shapetonFoldMatching.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** The map of the dissertation. */
struct PublishedMap
{
  CylinderMap  map;
  FoldMatching matching;
  /** Final weight of the center of each pair, 0 to 1. */
  std::vector<double> pairWeights;
  double              greatestDilatation{ 0.0 };
  /** See QuasiConformalMap. */
  int    solves{ 0 };
  double greatestMiss{ 0.0 };
};

/** Supine to prone map as in 4.3 and 5.4.2 of the dissertation, which refers to Zeng, Marino, Gurijala, Gu, Kaufman
 * 2010: a quasi-conformal map between the conformal flat walls through landmarks. Ends and flexures are circles that
 * may rotate; the main taenia, along which the method cuts the wall, is mapped to the main taenia. Folds are matched
 * once under this map, per segment, and the final map is constrained by the ends of all matched folds, correct or not.
 *
 * The dissertation does not specify how the Beltrami coefficient is computed; see FindQuasiConformalMap(). The higher
 * weights that it gives to ends of folds near the main taenia are not possible with hard constraints. Here the map is
 * periodic, and `frame` determines the correspondence of the taeniae. */
PublishedMap
FindPublishedMap(const ColonPair &   pair,
                 const CylinderMap & frame,
                 FoldMatchingMethod  method,
                 double              greatestDilatation,
                 const Progress &    progress = {});

/** The same map, constrained only by the ends of the given fold pairs and the ends of the colon. */
CylinderMap
QuasiConformalMapThrough(const ColonPair &    pair,
                         const CylinderMap &  start,
                         const FoldMatching & matching,
                         double               greatestDilatation);
} // namespace shapeton

#endif
