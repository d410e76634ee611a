#include "shapetonRegistrationConfidence.h"

#include "shapetonShiftProbability.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double followed = 0.5; ///< minimum weight of a consistent pair

/** Number of landmarks outside excluded columns. */
int
SeenLandmarks(const ColonCylinder &             cylinder,
              const ColonPosition &             position,
              const std::vector<FoldLandmark> & landmarks)
{
  return static_cast<int>(std::count_if(landmarks.begin(), landmarks.end(), [&](const FoldLandmark & landmark) {
    const int column = cylinder.Grid().PixelOfUv(landmark.Uv(position.folds)).column;
    return position.isExcluded.empty() || !position.isExcluded[column];
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
  const int  seen = std::min(SeenLandmarks(*registration.source, source, registration.sourceLandmarks),
                            SeenLandmarks(*registration.target, target, registration.targetLandmarks));
  const auto pairs = static_cast<double>(registration.matches.size());
  confidence.matchedShare = seen > 0 ? std::min(1.0, followedPairs / static_cast<double>(seen)) : 0.0;
  confidence.contradictedShare = pairs > 0.0 ? 1.0 - followedPairs / pairs : 1.0;
  confidence.residual = std::sqrt(squares / std::max(1, followedPairs));
}

double
Logistic(double value, double middle, double width)
{
  return 1.0 / (1.0 + std::exp(-(value - middle) / width));
}

/** Mean residual (mm) of the matched folds near a position. */
class NearbyResiduals
{
public:
  NearbyResiduals(const ColonPosition & source, const SupineProneRegistration & registration)
    : m_Around(registration.source->Around())
  {
    for (const FoldMatch & match : registration.matches)
    {
      m_Residuals.push_back({ registration.source->PlaceOfUv(match.source.Uv(source.folds)), match.residual });
    }
  }

  double
  At(const CylinderPlace & place) const
  {
    constexpr double reach = 25.0; // mm, standard deviation: about the distance of two folds
    constexpr double doubt = 0.1;  // weight of a prior residual of 10 mm, for positions without folds
    double           sum = doubt * ConfidentDistance;
    double           weights = doubt;
    for (const Residual & one : m_Residuals)
    {
      const double along = (place.s - one.place.s) / reach;
      const double around = TurnDifference(place.turn, one.place.turn) * m_Around / reach;
      const double weight = std::exp(-0.5 * (along * along + around * around));
      sum += weight * one.residual;
      weights += weight;
    }
    return sum / weights;
  }

private:
  struct Residual
  {
    CylinderPlace place;
    double        residual;
  };
  double                m_Around;
  std::vector<Residual> m_Residuals;
};

/** Probability that an error is at most ConfidentDistance if folds are matched correctly. Folds slide and rotate by a
 * fraction of the circumference, so errors are larger in a wide colon; residuals show where the map does not follow the
 * folds. Fitted by logistic regression on points with errors of at most 15 mm in 10 phantoms (realistic 1 to 5, hard 1
 * to 4, standard 1; true lumen in 1.2 mm voxels). */
double
ProbabilityOfSmallError(double radius, double residual)
{
  constexpr double sure = 4.43;        // log-odds; fitted, see above
  constexpr double perRadius = 0.042;  // 1/mm; fitted
  constexpr double perResidual = 0.53; // 1/mm; fitted
  return Logistic(sure - perRadius * radius - perResidual * residual, 0.0, 1.0);
}

/** Radius (mm) at a distance along the colon. */
double
RadiusAt(const ColonCylinder & cylinder, double s)
{
  const auto last = static_cast<double>(cylinder.Radii().size() - 1);
  return cylinder.Radii()[static_cast<Eigen::Index>(std::clamp(cylinder.ColumnOfArc(s), 0.0, last))];
}

/** Probability that each node is mapped onto the right fold, times the probability of a small error there. */
void
JudgeNodes(const ColonPair & pair, SupineProneRegistration & registration)
{
  const CylinderNodes & nodes = registration.map.Nodes();
  const Eigen::VectorXd noShift = ProbabilityOfNoShift(pair, registration);
  const NearbyResiduals residuals(pair.source, registration);
  Eigen::MatrixXd &     ofNodes = registration.confidence.ofNodes;
  ofNodes.setZero(nodes.Rows(), nodes.Angles());
  for (int i = 0; i < nodes.Rows(); ++i)
  {
    for (int j = 0; j < nodes.Angles(); ++j)
    {
      if (!registration.isExcluded(i, j))
      {
        const CylinderPlace place{ nodes.begin + i * nodes.step, static_cast<double>(j) / nodes.Angles() };
        const double        radius = RadiusAt(*registration.target, nodes.s(i, j));
        ofNodes(i, j) = noShift[i] * ProbabilityOfSmallError(radius, residuals.At(place));
      }
    }
  }
}

/** Log-odds of one term. They are limited because, judged by its folds alone, the real pair looks like two patients. */
double
LogOdds(double value, double middle, double width)
{
  constexpr double most = 4.0; // log odds, 98 %; see colon-registration.md
  return std::clamp((value - middle) / width, -most, most);
}
} // namespace

double
RegistrationConfidence::ProbabilityOfOnePatient() const
{
  // Middles and widths, from phantoms of seeds 1 to 10. For senseMargin, matchedShare, energy and margin, the values
  // are at most 0.042, 0.60 to 0.75, 0.13 to 0.34 and 0.04 to 0.15 in 14 pairs of two patients, and at least 0.052, at
  // least 0.80, at most 0.13 and at least 0.14 in 20 pairs of one patient.
  constexpr double sense = 0.047, widthOfSense = 0.008;
  constexpr double matched = 0.775, widthOfMatched = 0.05;
  constexpr double energyOfPair = 0.13, widthOfEnergy = 0.015;
  constexpr double thirds = 0.145, widthOfThirds = 0.02;
  const double     ofSense = LogOdds(senseMargin, sense, widthOfSense);
  const double     ofAll = ofSense + LogOdds(matchedShare, matched, widthOfMatched) +
                       LogOdds(-energy, -energyOfPair, widthOfEnergy) + LogOdds(margin, thirds, widthOfThirds);
  // Without the limit imposed by ofSense, two schematic colons of different patients pass.
  return Logistic(std::min(ofAll, ofSense), 0.0, 1.0);
}

void
JudgeRegistration(const ColonPair & pair, SupineProneRegistration & registration)
{
  CountMatches(pair.source, pair.target, registration);
  JudgeNodes(pair, registration);
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
