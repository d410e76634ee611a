#ifndef PolypPair_h
#define PolypPair_h

#include "LandmarkTrial.h"

#include "shapetonPolypCandidates.h"

#include <vector>

/** Candidates as SearchPolyps() judges them by one position, without the shape diffusion, which counts for nothing. */
std::vector<shapeton::PolypCandidate>
FindJudgedCandidates(const ColonExam & exam, double sensitivity);

/** Weighs the candidates of two positions of a patient by each other, as a run of both does: registered by the
 * landmarks that are found. False, and nothing is changed, where the positions cannot be registered. */
bool
WeighPair(const ColonExam &                       first,
          const ColonExam &                       second,
          std::vector<shapeton::PolypCandidate> & ofFirst,
          std::vector<shapeton::PolypCandidate> & ofSecond);

#endif
