#ifndef RegistrationTrial_h
#define RegistrationTrial_h

#include "LandmarkTrial.h"
#include "Reliability.h"

#include "shapetonRegistrationErrors.h"
#include "shapetonRegistrationSchemes.h"

#include <array>
#include <map>

/** Number of feature points (ends of visible folds) in one segment, and of those of the source that are matched
 * correctly, wrongly or not at all (Table 4.1 of the dissertation, which counts unmatched points as incorrect). */
struct FeaturePointCounts
{
  int source{ 0 };
  int target{ 0 };
  int correct{ 0 };
  int wrong{ 0 };

  void
  Add(const FeaturePointCounts & other);
};

/** Counts by segment, 1 to 6; index 0 is the whole colon. */
using FeaturePointTable = std::array<FeaturePointCounts, 7>;

/** Classes of the local confidence, which is mostly high. */
inline const std::vector<double> LocalClasses{ 0.0, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95, 1.0 };

/** Common numbers of taeniae compared with the truth. */
struct TaeniaScore
{
  bool areKnown{ false };
  /** Whether each taenia of the source and its partner follow the same true taenia along most of their length. */
  bool   areRight{ false };
  double probability{ 0.0 };
  /** Fraction of the source taeniae that are at the same true taenia as their partner at the mapped place. */
  double share{ 0.0 };
};

/** Names of the taeniae of one position compared with those of a phantom with anatomicalTaeniae. */
struct TaeniaNameScore
{
  bool areKnown{ false };
  bool areRight{ false };
  /** Why they are unknown. */
  std::string reason;
};

/** Result of one registration scheme. */
struct SchemeScore
{
  shapeton::RegistrationErrors errors;
  int                          flips{ 0 };
};

/** Results of one synthetic patient, prone registered to supine or vice versa, compared with the truth. */
struct RegistrationScore
{
  /** Errors of the map, of the frame, and of simpler schemes; the keys are table labels. */
  shapeton::RegistrationErrors errors;
  shapeton::RegistrationErrors frame;
  /** Local confidence at the measured points, and whether their error is within ConfidentDistance. */
  Reliability                        local{ LocalClasses };
  std::map<std::string, SchemeScore> schemes;
  int                                flips{ 0 };
  bool                               isFlagged{ false };
  double                             confidence{ 0.0 };
  double                             seconds{ 0.0 };
  /** Common numbers of the taeniae. */
  TaeniaScore                    taeniae;
  std::array<TaeniaNameScore, 2> names; ///< of the first and second exam
  /** Numbers of correct fold pairs, all pairs, and folds visible in both positions. */
  int right{ 0 };
  int pairs{ 0 };
  int common{ 0 };
  /** Ends of all folds, matched together with their folds; and ends near the main taenia, matched by the published
   * method. */
  FeaturePointTable points;
  FeaturePointTable publishedPoints;
  /** Empty, or the reason why the map is missing. */
  std::string failure;
};

/** Creates the registration input of an exam, with landmarks from ColonLandmarks or true landmarks. `names` receives
 * the names of the taeniae that were found. */
shapeton::ColonPosition
MakeColonPosition(const LandmarkExam &    exam,
                  const std::string &     name,
                  bool                    hasTrueLandmarks,
                  shapeton::TaeniaNames * names = nullptr);

/** Wall points visible in both positions, outside of truly collapsed sections. */
std::vector<shapeton::PointPair>
TruePairs(const shapeton::ColonAnatomy & source, const shapeton::ColonAnatomy & target);

/** Registers the first exam to the second and measures the errors. `comparesSchemes` adds the simpler schemes. */
RegistrationScore
TryRegistration(const LandmarkExam & first, const LandmarkExam & second, bool hasTrueLandmarks, bool comparesSchemes);

/** Whether exams of two different patients are flagged or rejected. */
bool
AreToldApart(const LandmarkExam & first, const LandmarkExam & second);

#endif
