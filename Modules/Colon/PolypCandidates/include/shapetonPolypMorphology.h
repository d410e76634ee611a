#ifndef shapetonPolypMorphology_h
#define shapetonPolypMorphology_h

#include "shapetonPolypCandidates.h"

#include <functional>

namespace shapeton
{
/** Sets morphology, isOnFold, planeDiameter and plane of the candidates.
 *
 * - Flat: at most 3 mm high, and lower than half of the smallest width (C-RADS; Paris classification 0-IIa).
 * - Pedunculated: 2 to 4 mm beyond the edge of the head, along the surface, the girth is less than 0.8 times that of
 *   the head. A stalk is narrower than its head there; the wall around a sessile polyp is wider.
 * - On a fold: most of the wall within 2 mm of the head belongs to folds.
 *
 * \param isFold whether a point of the wall (LPS, mm) belongs to a fold; empty if folds are unknown.
 *
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
MeasureMorphology(const SurfaceMesh &                                  wall,
                  const std::function<bool(const Eigen::Vector3d &)> & isFold,
                  std::vector<PolypCandidate> &                        candidates);

/** Sets mainCandidate of candidates whose heads are within 4 mm of the head of a candidate with a higher score: they
 * are fragments of one structure. A possible polyp is never a fragment of a lookalike. \pre Sorted by
 * descending score. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
JoinFragments(const SurfaceMesh & wall, std::vector<PolypCandidate> & candidates);

/** "sessile", "pedunculated, on a fold", ...; "diminutive" instead of a form if the larger size is at most 5 mm; empty
 * if unknown. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                               MorphologyInWords(const PolypCandidate & candidate);
} // namespace shapeton

#endif
