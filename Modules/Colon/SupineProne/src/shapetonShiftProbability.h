#ifndef shapetonShiftProbability_h
#define shapetonShiftProbability_h

#include "shapetonColonPair.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Probability, for each row of nodes of the map, that the row is not mapped onto a neighboring fold.
 *
 * Hidden Markov model along the colon. The state of a row consists of the displacement of its image along the target,
 * relative to the map, and of its rotation. A state is likely if the folds of the row agree with the displaced target.
 * A change from row to row is unlikely, except where the wall is not visible. Since the rotation is absolute, a map
 * that twists by a third of a turn, to the next taenia, must be supported by folds. Marginal probabilities are computed
 * forward and backward (Rabiner, Proceedings of the IEEE 77, 1989, 257-286); the result is the sum over displacements
 * of at most 15 mm. Where folds repeat periodically, all displacements by a period are equally likely. */
Eigen::VectorXd
ProbabilityOfNoShift(const ColonPair & pair, const SupineProneRegistration & registration);
} // namespace shapeton

#endif
