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
  /** How much the map follows the center of each pair, 0 to 1. */
  std::vector<double> pairWeights;
  double              greatestDilatation{ 0.0 };
  /** See QuasiConformalMap. */
  int    solves{ 0 };
  double greatestMiss{ 0.0 };
};

/** Supine to prone as in 4.3 and 5.4.2 of the dissertation, which refers to Zeng, Marino, Gurijala, Gu, Kaufman 2010: a
 * quasi-conformal map of the conformal flat walls through landmarks. Ends and flexures map to ends and flexures, as
 * circles that may rotate, and the main taenia, along which the method cuts the wall, to the main taenia. Folds are
 * matched once about this map, segment by segment, and the final map is forced through the ends of all matched folds,
 * right or wrong.
 *
 * The dissertation does not specify how the Beltrami coefficient is found; see FindQuasiConformalMap(). It gives ends
 * of folds near the main taenia more weight than others, which hard constraints cannot. Here the map is periodic
 * around, and `frame` determines the correspondence of the taeniae. */
PublishedMap
FindPublishedMap(const ColonPair &   pair,
                 const CylinderMap & frame,
                 FoldMatchingMethod  method,
                 double              greatestDilatation,
                 const Progress &    progress = {});

/** The same map through only the ends of already matched folds and the ends of the colon. */
CylinderMap
QuasiConformalMapThrough(const ColonPair &    pair,
                         const CylinderMap &  start,
                         const FoldMatching & matching,
                         double               greatestDilatation);
} // namespace shapeton

#endif
