#ifndef shapetonPublishedMap_h
#define shapetonPublishedMap_h

#include "shapetonColonPair.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** The map of the dissertation. */
struct PublishedMap
{
  CylinderMap map;
  /** Ends of folds near the main taenia, and the pairs of them that constrain the map. */
  std::vector<FoldLandmark> sourceLandmarks;
  std::vector<FoldLandmark> targetLandmarks;
  FoldMatching              matching;
  /** Final weight of each pair, 0 to 1. */
  std::vector<double> pairWeights;
  double              greatestDilatation{ 0.0 };
  /** See QuasiConformalMap. */
  int    solves{ 0 };
  double greatestMiss{ 0.0 };
};

/** Supine to prone map as in 4.3.1 and 5.4.2 of the dissertation, which refers to Zeng, Marino, Gurijala, Gu, Kaufman
 * 2010: a quasi-conformal map between the conformal flat walls through landmarks. Ends of the colon and flexures are
 * circles that may rotate; the main taenia, along which the method cuts the wall, is mapped to the main taenia. Under
 * this map, all ends of folds are matched by MatchFeaturePoints() within each segment; the matched ends that are within
 * `border` of the main taenia in both positions constrain the final map, correct or not.
 *
 * The dissertation does not specify how the Beltrami coefficient is computed; see FindQuasiConformalMap(). Here the map
 * is periodic, and `frame` determines which taenia of the target is the main one. Throws InputError if a position has
 * no taeniae. */
PublishedMap
FindPublishedMap(const ColonPair &          pair,
                 const CylinderMap &        frame,
                 const SupineProneOptions & options,
                 const Progress &           progress = {});

/** The same map, constrained only by the ends of the given fold pairs and the ends of the colon. */
CylinderMap
QuasiConformalMapThrough(const ColonPair &    pair,
                         const CylinderMap &  start,
                         const FoldMatching & matching,
                         double               greatestDilatation);
} // namespace shapeton

#endif
