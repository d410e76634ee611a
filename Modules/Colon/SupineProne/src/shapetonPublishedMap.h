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
  /** How much the map follows the middle of each pair, 0 to 1. */
  std::vector<double> pairWeights;
  double              greatestDilatation{ 0.0 };
  /** See QuasiConformalMap. */
  int    solves{ 0 };
  double greatestMiss{ 0.0 };
};

/** Supine to prone as in 4.3 and 5.4.2 of the dissertation, which refers to Zeng, Marino, Gurijala, Gu, Kaufman 2010: a
 * quasi-conformal map of the flat walls, which are conformal, through landmarks. Ends and flexures go to ends and
 * flexures, as circles that may turn, and the main taenia, along which the method cuts the wall, goes to the main
 * taenia. Folds are matched once about the map that this gives, segment by segment, and the final map is forced
 * through the ends of all that were matched, right or wrong.
 *
 * Open in the dissertation, and chosen here: how the Beltrami coefficient is found, see FindQuasiConformalMap(). It
 * gives ends of folds near the main taenia more weight than others, which hard constraints cannot. Other than there
 * the map is periodic around, and `frame` tells which taenia is which. */
PublishedMap
FindPublishedMap(const ColonPair &   pair,
                 const CylinderMap & frame,
                 FoldMatchingMethod  method,
                 double              greatestDilatation,
                 const Progress &    progress = {});

/** The same map through the ends of folds that are matched already, and the ends of the colon, but nothing else. */
CylinderMap
QuasiConformalMapThrough(const ColonPair &    pair,
                         const CylinderMap &  start,
                         const FoldMatching & matching,
                         double               greatestDilatation);
} // namespace shapeton

#endif
