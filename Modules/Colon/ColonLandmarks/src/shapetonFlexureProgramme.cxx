#include "shapetonFlexureProgramme.h"

#include "shapetonFlexurePrior.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int stride = 2; // of the shape's steps
/** One feature alone cannot rule a place out: squared deviations are cut off here. */
constexpr double greatestDeviation = 60.0;
/** Nor can one point of the descending colon: the logarithm of its likelihood ratio is cut off here. */
constexpr double leastRatio = -12.0;
/** Least share of the length between flexures. */
constexpr double leastGap = 0.02;
/** The features depend on each other: the likelihood counts for so much where probabilities are stated. Calibrated on
 * phantoms of the preset realistic, seeds 1 to 24. */
constexpr double tempering = 0.6;
/** Points of a section depend on each other over so many mm. */
constexpr double sectionCorrelation = 40.0;
constexpr double tolerance = 30.0; // mm
constexpr double impossibleTerms = -1e30;
/** Of situs inversus (about 1 in 10,000) and, more often, of images whose sides were exchanged on their way. */
constexpr double probabilityOfMirrored = 1e-3;
/** Of a line that begins at the caecum, as where the scan or the gas ends before the rectum. */
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

/** The likelihood ratio of the course of the descending colon when it is a usual one or, more seldom, redundant: then
 * its course tells nothing. Places did not change for shares of redundant ones from 0.02 to 0.3. */
double
MixedWithRedundant(double ratioOfUsual)
{
  constexpr double redundant = 0.1;
  const auto [lesser, greater] = std::minmax({ std::log(1.0 - redundant) + ratioOfUsual, std::log(redundant) });
  return greater + std::log1p(std::exp(lesser - greater));
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

class FlexureProgramme
{
public:
  explicit FlexureProgramme(const CentrelineShape & shape) : m_Last(shape.Size() - 1)
  {
    this->FindFeatures(shape);
    this->ScoreDescendingColon(shape);
    this->ScorePlaces();
    m_Sums = this->SumsThrough();
  }

  FlexurePlaces
  Run() const
  {
    const std::array<int, 4> places = this->BestPlaces();
    FlexurePlaces            result;
    // Only the descending-sigmoid flexure is no apex, to which a place could move.
    std::array<int, 4> moved = places;
    moved[1] = this->MeanPlaceNear(places[1], 1);
    result.confidence = this->Confidences(moved);
    for (int k = 0; k < 4; ++k)
    {
      result.at[k] = moved[k] * stride;
      result.meanDeviation[k] = SquaredDeviation(TheFlexurePriors[k], m_Features[places[k]]) / NumberOfFlexureFeatures;
    }
    return result;
  }

  /** The log-likelihood of the line, whatever the places: tempered, up to a constant. */
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
  FindFeatures(const CentrelineShape & shape)
  {
    const VertexMatrix    box = shape.PlacesInBox();
    const VertexMatrix    tangents = shape.Tangents(8.0);
    const Eigen::VectorXd near = shape.Turning(35.0, 8.0);
    const Eigen::VectorXd far = shape.Turning(70.0, 8.0);
    const int             reach = static_cast<int>(40.0 / CentrelineShape::Step);
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

  /** Sums over the points up to each one: how much likelier it lies in the descending colon than anywhere, in any
   * direction. */
  void
  ScoreDescendingColon(const CentrelineShape & shape)
  {
    const VertexMatrix box = shape.PlacesInBox();
    const VertexMatrix tangents = shape.Tangents(15.0);
    const double       weight = stride * CentrelineShape::Step / sectionCorrelation;
    double             sum = 0.0;
    for (int i = 0; i <= m_Last; i += stride)
    {
      m_Descending.push_back(sum);
      double score = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        score += TheDescendingColon.place[axis].LogDensity(box(i, axis));
        score += TheDescendingColon.direction[axis].LogDensity(tangents(i, axis)) + std::log(2.0);
      }
      sum += weight * std::max(score, leastRatio);
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
      m_Scores[0][i] -= 0.5 * TheLengthOfRectum.SquaredDeviation(share * m_Last * CentrelineShape::Step);
      m_Scores[3][i] -= 0.5 * ThePriorOfRightColon.SquaredDeviation(1.0 - share);
    }
  }

  /** Of the colon between flexure k and the one before. */
  double
  PairScore(int k, int from, int to) const
  {
    const double share = m_Features[to][0] - m_Features[from][0];
    if (share < leastGap)
    {
      return impossibleTerms;
    }
    constexpr int splenic = 2;
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

  /** The mean of a flexure's places within 60 mm of its best one, each counting by its probability: the best course
   * begins the descending colon too early, as each point that looks like it adds to its likelihood. */
  int
  MeanPlaceNear(int place, int k) const
  {
    constexpr double spread = 60.0; // mm
    const int        reach = static_cast<int>(spread / (CentrelineShape::Step * stride));
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

  /** Log sums over all places of the flexure before (or behind), for each place of the next one. */
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

  /** The probability of each flexure to lie within the tolerance of its place. */
  std::array<double, 4>
  Confidences(const std::array<int, 4> & at) const
  {
    std::array<double, 4> result{};
    const int             reach = static_cast<int>(tolerance / (CentrelineShape::Step * stride));
    for (int k = 0; k < 4; ++k)
    {
      const Scores close(m_Sums[k].begin() + std::max(at[k] - reach, 0),
                         m_Sums[k].begin() + std::min(at[k] + reach + 1, this->Size()));
      result[k] = std::exp(std::min(LogSum(close) - LogSum(m_Sums[k]), 0.0));
    }
    return result;
  }

  /** For each flexure and place the log sum over all courses with the flexure there (forward and backward sums). */
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
  /** The log-likelihood of each place for each flexure, with the ends of the colon. */
  std::array<Scores, 4> m_Scores;
  std::array<Scores, 4> m_Sums; ///< SumsThrough()
};
} // namespace

FlexurePlaces
FindFlexurePlaces(const CentrelineShape & shape)
{
  const FlexureProgramme usual(shape);
  const FlexureProgramme mirrored(shape.Mirrored());
  const FlexureProgramme backwards(shape.Reversed());
  const Scores           senses{ usual.Evidence() + std::log(1.0 - probabilityOfMirrored - probabilityOfBackwards),
                       mirrored.Evidence() + std::log(probabilityOfMirrored),
                       backwards.Evidence() + std::log(probabilityOfBackwards) };
  const bool             isMirrored = senses[1] > senses[0];
  const double           score = std::max(senses[0], senses[1]);
  FlexurePlaces          places = isMirrored ? mirrored.Run() : usual.Run();
  places.isMirrored = isMirrored;
  places.isBackwards = senses[2] > score;
  for (double & confidence : places.confidence)
  {
    confidence *= std::exp(score - LogSum(senses)); // it takes the sense for granted
  }
  return places;
}
} // namespace shapeton
