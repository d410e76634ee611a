#include "PolypPair.h"

#include "RegistrationTrial.h"

#include "shapetonExceptions.h"
#include "shapetonPolypContent.h"
#include "shapetonPolypSearch.h"
#include "shapetonRegistrationResults.h"

using namespace shapeton;

namespace
{
ColonPositionFiles
PositionOf(const ColonExam & exam, const std::string & name)
{
  ColonPositionFiles files;
  files.position = MakeColonPosition(exam, name, false);
  return files;
}
} // namespace

std::vector<PolypCandidate>
FindJudgedCandidates(const ColonExam & exam, double sensitivity)
{
  PolypCandidateOptions options;
  options.sensitivity = sensitivity;
  std::vector<PolypCandidate> candidates = FindPolypCandidates(exam.wall, options);
  if (exam.ct)
  {
    MeasureContent(exam.wall, exam.ct, exam.lumen, candidates);
  }
  if (const auto valve = IleocecalValveOf(exam.centerline))
  {
    RankValveLast(*valve, candidates);
  }
  if (!exam.catheter.curves.empty())
  {
    RankCatheterLast(exam.catheter, candidates);
  }
  return candidates;
}

bool
WeighPair(const ColonExam &             first,
          const ColonExam &             second,
          std::vector<PolypCandidate> & ofFirst,
          std::vector<PolypCandidate> & ofSecond)
{
  try
  {
    const ColonPositionFiles      one = PositionOf(first, "the first position");
    const ColonPositionFiles      two = PositionOf(second, "the second position");
    const SupineProneRegistration registration = RegisterColonPositions(one.position, two.position);
    const RegistrationResults     results = MakeRegistrationResults(one, two, registration);
    const double                  confidence = registration.confidence.isFlagged ? 0.0 : registration.confidence.whole;
    const auto                    othersOfSecond = AsOthers(ofFirst);
    FindInOtherPosition(results.supineToProne, "the map", AsOthers(ofSecond), ofFirst);
    FindInOtherPosition(results.proneToSupine, "the map", othersOfSecond, ofSecond);
    WeighByOtherPosition(confidence, ofFirst);
    WeighByOtherPosition(confidence, ofSecond);
    return true;
  }
  catch (const Exception &)
  {
    return false;
  }
}
