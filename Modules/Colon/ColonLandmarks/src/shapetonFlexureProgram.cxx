#include "shapetonFlexureProgram.h"

#include "shapetonFlexurePrior.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace shapeton
{
namespace
{
constexpr int stride = 2; // in steps of the shape
/** Clamp of squared deviations, so that no single feature excludes a point. */
constexpr double greatestDeviation = 60.0;
/** Clamp of the log-likelihood ratio of one point of the descending colon, for the same reason. */
constexpr double leastRatio = -12.0;
/** Minimum length between flexures, as a fraction of the total length. */
constexpr double leastGap = 0.02;
/** Exponent of the likelihoods when computing probabilities, since the features are correlated. Calibrated on phantoms
 * of the presets realistic (seeds 1 to 40), standard and hard (1 to 20). Exponents from 0.6 to 1 change the Brier
 * scores of single flexures by at most 0.03. */
constexpr double tempering = 0.7;
/** Standard deviation (mm) of the border itself along the line, that is, of the positions that anatomists would accept;
 * it adds to the spread of the posterior. On the same phantoms, 10 to 20 mm are best for the descending-sigmoid and 0
 * to 10 mm for the splenic flexure (Brier scores differ by less than 0.01); the points marked by experts in two
 * patients require at least 20 mm for the former. */
constexpr std::array<double, 4> spreadOfBorder{ 0.0, 20.0, 10.0, 0.0 };
/** Maximum squared deviation, over two features, at which the bones support a position: 2.5 standard deviations. */
constexpr double greatestFromBones = 6.25;
/** Clamp of that deviation. If the bones contradict all other evidence, they were located incorrectly. */
constexpr double clampFromBones = 20.0;
constexpr int    junction = 1; // index of the descending-sigmoid flexure
/** Correlation length of the points of a section, mm. */
constexpr double sectionCorrelation = 40.0;
constexpr double tolerance = 30.0; // mm
constexpr double impossibleTerms = -1e30;
/** Prior probability of situs inversus (about 1 in 10,000) and, more often, of flipped images. */
constexpr double probabilityOfMirrored = 1e-3;
/** Prior probability of a line that begins at the cecum, for example because the scan or the gas ends before the
 * rectum. */
constexpr double probabilityOfBackwards = 1e-2;

using Scores = std::vector<double>;

double
LogSum(const Scores & terms)
{
  const double most = terms.empty() ? impossibleTerms : *std::max_element(terms.begin(), terms.end());
  double       sum = 0.0;
  for (const double term : terms)
  {
    sum += std::exp(term - most);
  }
  return most + std::log(std::max(sum, 1e-300));
}

Scores
Sum(Scores a, const Scores & b)
{
  std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::plus<>());
  return a;
}

/** Likelihood ratio of the course of the descending colon: a mixture of the usual colon and a rarer redundant one,
 * whose course is uninformative. The flexures did not change for mixture weights from 0.02 to 0.3. */
double
MixedWithRedundant(double ratioOfUsual)
{
  constexpr double redundant = 0.1; // mixture weight, see above
  const auto [lesser, greater] = std::minmax({ std::log(1.0 - redundant) + ratioOfUsual, std::log(redundant) });
  return greater + std::log1p(std::exp(lesser - greater));
}

/** Likelihood ratio of a point of the descending colon, including its iliac part, to a point of the colon. */
double
RatioOfDescending(const Eigen::RowVector3d & place, const Eigen::RowVector3d & tangent)
{
  return LogSum({ std::log(1.0 - TheShareOfIliacColon) + TheDescendingColon.LogRatio(place, tangent),
                  std::log(TheShareOfIliacColon) + TheIliacColon.LogRatio(place, tangent) });
}

double
SquaredDeviation(const Pelvis & pelvis, const Eigen::RowVector3d & point)
{
  return TheHeightAbovePromontory.SquaredDeviation(point.z() - pelvis.promontory.z()) +
         TheDistanceLeftOfPromontory.SquaredDeviation(point.x() - pelvis.promontory.x());
}

/** Probability that a border is within the tolerance of a position whose distance (mm) from the mean of the border is
 * given. */
double
ProbabilityOfClose(double distance, double spread)
{
  if (spread == 0.0)
  {
    return distance <= tolerance ? 1.0 : 0.0;
  }
  const double scale = 1.0 / (std::sqrt(2.0) * spread);
  return 0.5 * (std::erf((tolerance - distance) * scale) + std::erf((tolerance + distance) * scale));
}

double
SquaredDeviation(const FlexurePrior & prior, const FlexureFeatures & features)
{
  double sum = 0.0;
  for (int k = 0; k < NumberOfFlexureFeatures; ++k)
  {
    sum += prior.features[k].SquaredDeviation(features[k]);
  }
  return std::min(sum, greatestDeviation);
}

class FlexureProgram
{
public:
  FlexureProgram(const CenterlineShape & shape, const std::optional<Pelvis> & pelvis) : m_Last(shape.Size() - 1)
  {
    this->FindFeatures(shape);
    this->ScoreDescendingColon(shape);
    this->MeasureFromBones(shape, pelvis);
    this->ScorePlaces();
    m_Sums = this->SumsThrough();
  }

  FlexurePlaces
  Run() const
  {
    const std::array<int, 4> places = this->BestPlaces();
    FlexurePlaces            result;
    // The descending-sigmoid flexure is the only one without an apex.
    std::array<int, 4> moved = places;
    moved[junction] = this->MeanPlaceNear(places[junction], junction);
    result.isAtBrim = !m_FromBones.empty() && m_FromBones[moved[junction]] <= greatestFromBones;
    result.confidence = this->Confidences(moved);
    for (int k = 0; k < 4; ++k)
    {
      result.at[k] = moved[k] * stride;
      result.meanDeviation[k] = SquaredDeviation(TheFlexurePriors[k], m_Features[places[k]]) / NumberOfFlexureFeatures;
    }
    return result;
  }

  /** Log of the tempered likelihood of the line, summed over all flexure positions, up to a constant. */
  double
  Evidence() const
  {
    return LogSum(m_Sums[0]);
  }

private:
  int
  Size() const
  {
    return static_cast<int>(m_Features.size());
  }

  void
  FindFeatures(const CenterlineShape & shape)
  {
    const VertexMatrix    box = shape.PlacesInBox();
    const VertexMatrix    tangents = shape.Tangents(8.0);
    const Eigen::VectorXd near = shape.Turning(35.0, 8.0);
    const Eigen::VectorXd far = shape.Turning(70.0, 8.0);
    const int             reach = static_cast<int>(40.0 / CenterlineShape::Step);
    for (int i = 0; i <= m_Last; i += stride)
    {
      const auto before = tangents.row(std::max(i - reach, 0));
      const auto behind = tangents.row(std::min(i + reach, m_Last));
      m_Features.push_back({ static_cast<double>(i) / m_Last,
                             box(i, 0),
                             box(i, 1),
                             box(i, 2),
                             near[i] / 90.0,
                             far[i] / 90.0,
                             before[0],
                             before[1],
                             before[2],
                             behind[0],
                             behind[1],
                             behind[2] });
    }
  }

  /** Cumulative log-likelihood ratio of the descending colon to the whole colon. */
  void
  ScoreDescendingColon(const CenterlineShape & shape)
  {
    const VertexMatrix box = shape.PlacesInBox();
    const VertexMatrix tangents = shape.Tangents(15.0);
    const double       weight = stride * CenterlineShape::Step / sectionCorrelation;
    double             sum = 0.0;
    for (int i = 0; i <= m_Last; i += stride)
    {
      m_Descending.push_back(sum);
      sum += weight * std::max(RatioOfDescending(box.row(i), tangents.row(i)), leastRatio);
    }
  }

  void
  MeasureFromBones(const CenterlineShape & shape, const std::optional<Pelvis> & pelvis)
  {
    for (int i = 0; pelvis && i <= m_Last; i += stride)
    {
      m_FromBones.push_back(SquaredDeviation(*pelvis, shape.Points().row(i)));
    }
  }

  void
  ScorePlaces()
  {
    for (int i = 0; i < this->Size(); ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        m_Scores[k].push_back(-0.5 * SquaredDeviation(TheFlexurePriors[k], m_Features[i]));
      }
      const double share = m_Features[i][0];
      m_Scores[0][i] -= 0.5 * TheLengthOfRectum.SquaredDeviation(share * m_Last * CenterlineShape::Step);
      m_Scores[3][i] -= 0.5 * ThePriorOfRightColon.SquaredDeviation(1.0 - share);
      if (!m_FromBones.empty())
      {
        m_Scores[junction][i] -= 0.5 * std::min(m_FromBones[i], clampFromBones);
      }
    }
  }

  /** Log-likelihood of the section between flexure k and the previous one. */
  double
  PairScore(int k, int from, int to) const
  {
    const double share = m_Features[to][0] - m_Features[from][0];
    if (share < leastGap)
    {
      return impossibleTerms;
    }
    constexpr int splenic = 2; // index of the flexure, from 0 at the rectum
    const double  section = k == splenic ? MixedWithRedundant(m_Descending[to] - m_Descending[from]) : 0.0;
    return section - 0.5 * TheFlexurePriors[k].gap.SquaredDeviation(share);
  }

  std::array<int, 4>
  BestPlaces() const
  {
    Scores                          best = m_Scores[0];
    std::array<std::vector<int>, 4> from;
    for (int k = 1; k < 4; ++k)
    {
      Scores next(this->Size(), impossibleTerms);
      from[k].assign(this->Size(), 0);
      for (int i = 0; i < this->Size(); ++i)
      {
        for (int j = 0; j < i; ++j)
        {
          const double score = best[j] + this->PairScore(k, j, i);
          if (score > next[i])
          {
            next[i] = score;
            from[k][i] = j;
          }
        }
      }
      best = Sum(next, m_Scores[k]);
    }
    std::array<int, 4> places{};
    places[3] = static_cast<int>(std::max_element(best.begin(), best.end()) - best.begin());
    for (int k = 3; k > 0; --k)
    {
      places[k - 1] = from[k][places[k]];
    }
    return places;
  }

  /** Probability-weighted mean of the positions of a flexure within 60 mm of the optimum. The optimum lets the
   * descending colon begin too early, since each additional point of similar shape increases the likelihood. */
  int
  MeanPlaceNear(int place, int k) const
  {
    // mm. On realistic phantoms (seeds 1 to 24), the mean finds 177 of 192 flexures, the optimum 173.
    constexpr double spread = 60.0;
    const int        reach = static_cast<int>(spread / (CenterlineShape::Step * stride));
    double           sum = 0.0;
    double           moment = 0.0;
    for (int i = std::max(place - reach, 0); i <= std::min(place + reach, this->Size() - 1); ++i)
    {
      const double probability = std::exp(m_Sums[k][i] - m_Sums[k][place]);
      sum += probability;
      moment += probability * i;
    }
    return static_cast<int>(std::lround(moment / sum));
  }

  /** For each position of this flexure, the log sum over all positions of the previous (or next) one. */
  Scores
  SumOver(const Scores & from, int k, bool fromBefore) const
  {
    Scores sums;
    for (int i = 0; i < this->Size(); ++i)
    {
      Scores terms;
      for (int j = fromBefore ? 0 : i + 1; j < (fromBefore ? i : this->Size()); ++j)
      {
        const double score = fromBefore ? this->PairScore(k, j, i) : this->PairScore(k, i, j);
        if (score > impossibleTerms)
        {
          terms.push_back(from[j] + tempering * score);
        }
      }
      sums.push_back(LogSum(terms));
    }
    return sums;
  }

  /** Probability that each flexure is within the tolerance of its position. */
  std::array<double, 4>
  Confidences(const std::array<int, 4> & at) const
  {
    std::array<double, 4> result{};
    for (int k = 0; k < 4; ++k)
    {
      const double all = LogSum(m_Sums[k]);
      for (int i = 0; i < this->Size(); ++i)
      {
        const double distance = std::abs(i - at[k]) * CenterlineShape::Step * stride;
        result[k] += std::exp(m_Sums[k][i] - all) * ProbabilityOfClose(distance, spreadOfBorder[k]);
      }
      result[k] = std::min(result[k], 1.0);
    }
    return result;
  }

  /** For each flexure and position, the log sum over all solutions (forward-backward algorithm). */
  std::array<Scores, 4>
  SumsThrough() const
  {
    std::array<Scores, 4> scores = m_Scores;
    for (Scores & s : scores)
    {
      std::transform(s.begin(), s.end(), s.begin(), [](double value) { return tempering * value; });
    }
    std::array<Scores, 4> before;
    std::array<Scores, 4> behind;
    before[0].assign(this->Size(), 0.0);
    behind[3].assign(this->Size(), 0.0);
    for (int k = 1; k < 4; ++k)
    {
      before[k] = this->SumOver(Sum(before[k - 1], scores[k - 1]), k, true);
      behind[3 - k] = this->SumOver(Sum(behind[4 - k], scores[4 - k]), 4 - k, false);
    }
    for (int k = 0; k < 4; ++k)
    {
      scores[k] = Sum(Sum(before[k], behind[k]), scores[k]);
    }
    return scores;
  }

  int                          m_Last;
  std::vector<FlexureFeatures> m_Features;
  Scores                       m_Descending;
  /** Squared deviation of each position from that expected from the bones; empty if there is no pelvis. */
  Scores m_FromBones;
  /** Log-likelihood of each position for each flexure, including the ends of the colon. */
  std::array<Scores, 4> m_Scores;
  std::array<Scores, 4> m_Sums; ///< SumsThrough()
};
} // namespace

FlexurePlaces
FindFlexurePlaces(const CenterlineShape & shape, const std::optional<Pelvis> & pelvis)
{
  const FlexureProgram usual(shape, pelvis);
  const FlexureProgram mirrored(shape.Mirrored(), pelvis ? std::optional(Mirrored(*pelvis)) : std::nullopt);
  const FlexureProgram backwards(shape.Reversed(), pelvis);
  const Scores         senses{ usual.Evidence() + std::log(1.0 - probabilityOfMirrored - probabilityOfBackwards),
                       mirrored.Evidence() + std::log(probabilityOfMirrored),
                       backwards.Evidence() + std::log(probabilityOfBackwards) };
  const bool           isMirrored = senses[1] > senses[0];
  const double         score = std::max(senses[0], senses[1]);
  FlexurePlaces        places = isMirrored ? mirrored.Run() : usual.Run();
  places.isMirrored = isMirrored;
  places.isBackwards = senses[2] > score;
  for (double & confidence : places.confidence)
  {
    confidence *= std::exp(score - LogSum(senses)); // conditional on the direction
  }
  return places;
}
} // namespace shapeton
