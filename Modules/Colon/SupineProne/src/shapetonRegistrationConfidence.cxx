#include "shapetonRegistrationConfidence.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double followed = 0.5; ///< minimum weight of a consistent pair

bool
IsFoldSeen(const ColonCylinder & cylinder, const ColonPosition & position, const HaustralFold & fold)
{
  const int column = cylinder.Grid().PixelOfUv(fold.centerUv).column;
  return position.isExcluded.empty() || !position.isExcluded[column];
}

int
SeenFolds(const ColonCylinder & cylinder, const ColonPosition & position)
{
  return static_cast<int>(std::count_if(position.folds.begin(), position.folds.end(), [&](const HaustralFold & fold) {
    return IsFoldSeen(cylinder, position, fold);
  }));
}

void
CountMatches(const ColonPosition & source, const ColonPosition & target, SupineProneRegistration & registration)
{
  RegistrationConfidence & confidence = registration.confidence;
  int                      followedPairs = 0;
  double                   squares = 0.0;
  for (const FoldMatch & match : registration.matches)
  {
    if (match.weight >= followed)
    {
      ++followedPairs;
      squares += match.residual * match.residual;
    }
  }
  const int  seen = std::min(SeenFolds(*registration.source, source), SeenFolds(*registration.target, target));
  const auto pairs = static_cast<double>(registration.matches.size());
  confidence.matchedShare = seen > 0 ? std::min(1.0, followedPairs / static_cast<double>(seen)) : 0.0;
  confidence.contradictedShare = pairs > 0.0 ? 1.0 - followedPairs / pairs : 1.0;
  confidence.residual = std::sqrt(squares / std::max(1, followedPairs));
}

/** Confidence of each node from nearby consistent pairs and unexplained folds. */
void
JudgeNodes(const ColonPosition & source, SupineProneRegistration & registration)
{
  constexpr double reach = 25.0; // mm, standard deviation
  struct Evidence
  {
    CylinderPlace place;
    double        support;
  };
  std::vector<Evidence> evidence;
  std::vector<double>   weightOfFold(source.folds.size(), 0.0);
  for (const FoldMatch & match : registration.matches)
  {
    weightOfFold[match.source] = match.weight;
  }
  for (std::size_t i = 0; i < source.folds.size(); ++i)
  {
    evidence.push_back({ registration.source->PlaceOfUv(source.folds[i].centerUv), weightOfFold[i] });
  }
  const CylinderNodes & nodes = registration.map.Nodes();
  Eigen::MatrixXd &     ofNodes = registration.confidence.ofNodes;
  ofNodes.setZero(nodes.Rows(), nodes.Angles());
  for (int i = 0; i < nodes.Rows(); ++i)
  {
    for (int j = 0; j < nodes.Angles(); ++j)
    {
      constexpr double doubt = 0.5; // prior weight of an unexplained fold, for nodes without folds
      double           sum = 0.0;
      double           weights = doubt;
      for (const Evidence & item : evidence)
      {
        const double along = (nodes.begin + i * nodes.step - item.place.s) / reach;
        if (std::abs(along) > 3.0)
        {
          continue;
        }
        const double around = TurnDifference(static_cast<double>(j) / nodes.Angles(), item.place.turn) *
                              registration.source->Around() / reach;
        const double weight = std::exp(-0.5 * (along * along + around * around));
        sum += weight * item.support;
        weights += weight;
      }
      ofNodes(i, j) = registration.isExcluded(i, j) ? 0.0 : sum / weights;
    }
  }
}

double
Logistic(double value, double middle, double width)
{
  return 1.0 / (1.0 + std::exp(-(value - middle) / width));
}

/** Log-odds of one term, limited, because the folds of a real pair alone look like those of two patients. */
double
LogOdds(double value, double middle, double width)
{
  constexpr double most = 4.0;
  return std::clamp((value - middle) / width, -most, most);
}
} // namespace

double
RegistrationConfidence::ProbabilityOfOnePatient() const
{
  // Middles and widths, from phantoms of seeds 1 to 10. Margin of the sense, matched share, energy, margin of the
  // thirds: 14 pairs of two patients have at most 0.042, 0.60 to 0.75, 0.13 to 0.34, 0.04 to 0.15; 20 pairs of one
  // patient at least 0.052, at least 0.80, at most 0.13, at least 0.14.
  constexpr double sense = 0.047, widthOfSense = 0.008;
  constexpr double matched = 0.775, widthOfMatched = 0.05;
  constexpr double energyOfPair = 0.13, widthOfEnergy = 0.015;
  constexpr double thirds = 0.145, widthOfThirds = 0.02;
  const double     ofSense = LogOdds(senseMargin, sense, widthOfSense);
  const double     ofAll = ofSense + LogOdds(matchedShare, matched, widthOfMatched) +
                       LogOdds(-energy, -energyOfPair, widthOfEnergy) + LogOdds(margin, thirds, widthOfThirds);
  // Without the limit by the sense, two schematic colons of different patients pass.
  return Logistic(std::min(ofAll, ofSense), 0.0, 1.0);
}

void
JudgeRegistration(const ColonPosition & source, const ColonPosition & target, SupineProneRegistration & registration)
{
  CountMatches(source, target, registration);
  JudgeNodes(source, registration);
  RegistrationConfidence & confidence = registration.confidence;
  const double             ofOnePatient = confidence.ProbabilityOfOnePatient();
  const double             byContradiction = Logistic(-confidence.contradictedShare, -0.08, 0.02);
  const double             byMargin = Logistic(confidence.margin, 0.1, 0.02);
  confidence.whole = std::min({ ofOnePatient, byContradiction, byMargin });
  if (ofOnePatient < 0.5)
  {
    confidence.reasons.push_back("the folds of the two positions do not fit: these may be two patients");
  }
  else if (byContradiction < 0.5)
  {
    confidence.reasons.push_back("many pairs of folds contradict each other");
  }
  if (byMargin < 0.5)
  {
    confidence.reasons.push_back(
      "the taeniae may be confused: the folds fit nearly as well after rotation by a third of a turn");
  }
  confidence.isFlagged = !confidence.reasons.empty();
}
} // namespace shapeton
