#ifndef PolypPair_h
#define PolypPair_h

#include "LandmarkTrial.h"

#include "shapetonPolypCandidates.h"

#include <vector>

/** Candidates of SearchPolyps() in one position, without the shape diffusion, which does not affect the
 * score. */
std::vector<shapeton::PolypCandidate>
FindJudgedCandidates(const ColonExam & exam, double sensitivity);

/** Combines the candidates of two positions of a patient, as in a run of both: registered with the detected landmarks.
 * Returns false, without changes, if the positions cannot be registered. */
bool
WeighPair(const ColonExam &                       first,
          const ColonExam &                       second,
          std::vector<shapeton::PolypCandidate> & ofFirst,
          std::vector<shapeton::PolypCandidate> & ofSecond);

#endif
