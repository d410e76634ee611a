#ifndef RegistrationTrial_h
#define RegistrationTrial_h

#include "LandmarkTrial.h"

#include "shapetonRegistrationErrors.h"
#include "shapetonRegistrationSchemes.h"

#include <array>
#include <map>

/** Feature points of one segment of the source: ends of folds that can be seen, by what became of their fold (Table 4.1
 * of the dissertation, which counts unmatched ones as incorrect). */
struct FeaturePointCounts
{
  int correct{ 0 };
  int wrong{ 0 };
  int unmatched{ 0 };

  void
  Add(const FeaturePointCounts & other);
};

/** By segment, 1 to 6; 0 for the whole colon. */
using FeaturePointTable = std::array<FeaturePointCounts, 7>;

/** A map by one scheme. */
struct SchemeScore
{
  shapeton::RegistrationErrors errors;
  int                          flips{ 0 };
};

/** One synthetic patient, prone registered to supine or the other way about, against the truth. */
struct RegistrationScore
{
  /** Of the map, and of simpler ways to register. Keys are names for a table. */
  shapeton::RegistrationErrors       errors;
  shapeton::RegistrationErrors       frame;
  std::map<std::string, SchemeScore> schemes;
  int                                flips{ 0 };
  bool                               isFlagged{ false };
  double                             confidence{ 0.0 };
  double                             seconds{ 0.0 };
  /** Pairs of folds that are one fold in truth, all pairs, and folds that can be seen in both positions. */
  int right{ 0 };
  int pairs{ 0 };
  int common{ 0 };
  /** Ends within 15 mm of the border of the flat map, and all. */
  FeaturePointTable borderPoints;
  FeaturePointTable allPoints;
  /** Empty, or why there is no map. */
  std::string failure;
};

/** An exam as the registration takes it: with the landmarks that ColonLandmarks finds, or the true ones. */
shapeton::ColonPosition
MakeColonPosition(const LandmarkExam & exam, const std::string & name, bool hasTrueLandmarks);

/** Points of the wall that both positions have, outside true collapse. */
std::vector<shapeton::PointPair>
TruePairs(const shapeton::ColonAnatomy & source, const shapeton::ColonAnatomy & target);

/** Registers the first to the second and measures. `comparesSchemes` adds the simpler ones. */
RegistrationScore
TryRegistration(const LandmarkExam & first, const LandmarkExam & second, bool hasTrueLandmarks, bool comparesSchemes);

/** Whether exams of two patients are told apart: flagged, or refused. */
bool
AreToldApart(const LandmarkExam & first, const LandmarkExam & second);

#endif
