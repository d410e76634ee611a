#include "itkColonFlexures.h"

#include "itkCentrelineShape.h"
#include "itkPublishedFlexures.h"
#include "itkFlexurePrior.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
constexpr double leastColon = 800.0; // mm
constexpr int    stride = 2;         // of the shape's steps
/** One feature alone cannot rule a place out: squared deviations are cut off here. */
constexpr double greatestDeviation = 60.0;
/** Mean squared deviation of a feature beyond which nothing like the flexure is there. */
constexpr double greatestMeanDeviation = 4.0;
/** Least share of the length between flexures. */
constexpr double leastGap = 0.02;
/** The features depend on each other: the likelihood counts for a third where probabilities are stated. */
constexpr double tempering = 1.0 / 3.0;
constexpr double tolerance = 30.0; // mm
/** How far the apex may lie from the best place, mm: of the upper flexures, and of the lower ones. */
constexpr double upperReach = 16.0;
constexpr double lowerReach = 24.0;
constexpr double impossible = -1e30;

using Scores = std::vector<double>;

std::vector<FlexureFeatures>
FeaturesOf(const CentrelineShape & shape)
{
  const VertexMatrix    box = shape.PlacesInBox();
  const VertexMatrix    tangents = shape.Tangents(8.0);
  const Eigen::VectorXd near = shape.Turning(35.0, 8.0);
  const Eigen::VectorXd far = shape.Turning(70.0, 8.0);
  const int             reach = static_cast<int>(40.0 / CentrelineShape::Step);
  const int             last = shape.Size() - 1;

  std::vector<FlexureFeatures> features;
  for (int i = 0; i < shape.Size(); i += stride)
  {
    const auto before = tangents.row(std::max(i - reach, 0));
    const auto behind = tangents.row(std::min(i + reach, last));
    features.push_back({ static_cast<double>(i) / last,
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
  return features;
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

/** The log-likelihood of each place for each flexure; the last one with what is left of the colon. */
std::array<Scores, 4>
PlaceScores(const std::vector<FlexureFeatures> & features)
{
  std::array<Scores, 4> scores;
  for (int k = 0; k < 4; ++k)
  {
    for (const FlexureFeatures & f : features)
    {
      scores[k].push_back(-0.5 * SquaredDeviation(TheFlexurePriors[k], f));
    }
  }
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    scores[0][i] -= 0.5 * TheFlexurePriors[0].gap.SquaredDeviation(features[i][0]);
    scores[3][i] -= 0.5 * ThePriorOfRightColon.SquaredDeviation(1.0 - features[i][0]);
  }
  return scores;
}

double
GapScore(int flexure, double share)
{
  return share < leastGap ? impossible : -0.5 * TheFlexurePriors[flexure].gap.SquaredDeviation(share);
}

/** The best four places in their order. */
std::array<int, 4>
BestPlaces(const std::vector<FlexureFeatures> & features, const std::array<Scores, 4> & scores)
{
  const int                       size = static_cast<int>(features.size());
  Scores                          best = scores[0];
  std::array<std::vector<int>, 4> from;
  for (int k = 1; k < 4; ++k)
  {
    Scores next(size, impossible);
    from[k].assign(size, 0);
    for (int i = 0; i < size; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        const double score = best[j] + GapScore(k, features[i][0] - features[j][0]);
        if (score > next[i])
        {
          next[i] = score;
          from[k][i] = j;
        }
      }
      next[i] += scores[k][i];
    }
    best = next;
  }
  std::array<int, 4> places{};
  places[3] = static_cast<int>(std::max_element(best.begin(), best.end()) - best.begin());
  for (int k = 3; k > 0; --k)
  {
    places[k - 1] = from[k][places[k]];
  }
  return places;
}

double
LogSum(const Scores & terms)
{
  const double most = terms.empty() ? impossible : *std::max_element(terms.begin(), terms.end());
  double       sum = 0.0;
  for (const double term : terms)
  {
    sum += std::exp(term - most);
  }
  return most + std::log(std::max(sum, 1e-300));
}

/** Log sums over all choices of the flexures before (or behind) flexure k, for each place of it. */
Scores
SumOver(const std::vector<FlexureFeatures> & features, const Scores & from, int k, bool fromBefore)
{
  const int size = static_cast<int>(features.size());
  Scores    sums(size, impossible);
  Scores    terms;
  for (int i = 0; i < size; ++i)
  {
    terms.clear();
    for (int j = fromBefore ? 0 : i + 1; j < (fromBefore ? i : size); ++j)
    {
      const double share = std::abs(features[i][0] - features[j][0]);
      if (share >= leastGap)
      {
        terms.push_back(from[j] + tempering * GapScore(k, share));
      }
    }
    sums[i] = LogSum(terms);
  }
  return sums;
}

/** The probability of each flexure to lie within the tolerance of its place (forward and backward sums). */
std::array<double, 4>
Confidences(const std::vector<FlexureFeatures> & features, std::array<Scores, 4> scores, const std::array<int, 4> & at)
{
  const int size = static_cast<int>(features.size());
  for (Scores & s : scores)
  {
    for (double & value : s)
    {
      value *= tempering;
    }
  }
  std::array<Scores, 4> before;
  std::array<Scores, 4> behind;
  before[0].assign(size, 0.0);
  behind[3].assign(size, 0.0);
  const auto plus = [](Scores a, const Scores & b) {
    std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::plus<>());
    return a;
  };
  for (int k = 1; k < 4; ++k)
  {
    before[k] = SumOver(features, plus(before[k - 1], scores[k - 1]), k, true);
    behind[3 - k] = SumOver(features, plus(behind[4 - k], scores[4 - k]), 4 - k, false);
  }
  std::array<double, 4> result{};
  const int             reach = static_cast<int>(tolerance / (CentrelineShape::Step * stride));
  for (int k = 0; k < 4; ++k)
  {
    const Scores all = plus(plus(before[k], behind[k]), scores[k]);
    const Scores close(all.begin() + std::max(at[k] - reach, 0), all.begin() + std::min(at[k] + reach + 1, size));
    result[k] = std::exp(std::min(LogSum(close) - LogSum(all), 0.0));
  }
  return result;
}

/** Near by, of the upper flexures the topmost place, of several as high the one farther back: the flexures are fixed to
 * the posterior wall, and the transverse colon hangs forwards from them. Of the lower ones the sharpest. */
int
SnapToApex(const CentrelineShape & shape, const Eigen::VectorXd & turning, int flexure, int place)
{
  const int reach = static_cast<int>((flexure >= 2 ? upperReach : lowerReach) / CentrelineShape::Step);
  int       best = place;
  double    most = impossible;
  for (int i = std::max(0, place - reach); i <= std::min(shape.Size() - 1, place + reach); ++i)
  {
    const double distance = std::abs(i - place) * CentrelineShape::Step;
    const double value =
      flexure >= 2 ? shape.Points()(i, 2) + 0.5 * shape.Points()(i, 1) - 0.01 * distance : turning[i] - 0.5 * distance;
    if (value > most)
    {
      most = value;
      best = i;
    }
  }
  return best;
}

void
PlaceFlexure(const CentrelineShape & shape, const VertexMatrix & tangents, int i, ColonFlexure & flexure)
{
  flexure.point = shape.Points().row(i).transpose();
  flexure.tangent = tangents.row(i).transpose();
  flexure.arcLength = shape.ArcLengthAt(i);
}

void
FindOrdered(const CentrelineShape & shape, ColonFlexures & result)
{
  const std::vector<FlexureFeatures> features = FeaturesOf(shape);
  const std::array<Scores, 4>        scores = PlaceScores(features);
  const std::array<int, 4>           places = BestPlaces(features, scores);
  const std::array<double, 4>        confidences = Confidences(features, scores, places);
  const Eigen::VectorXd              turning = 0.5 * (shape.Turning(35.0, 8.0) + shape.Turning(70.0, 8.0));
  const VertexMatrix                 tangents = shape.Tangents(10.0);
  for (int k = 0; k < 4; ++k)
  {
    ColonFlexure & flexure = result.flexures[k];
    const double   deviation = SquaredDeviation(TheFlexurePriors[k], features[places[k]]) / NumberOfFlexureFeatures;
    PlaceFlexure(shape, tangents, SnapToApex(shape, turning, k, places[k] * stride), flexure);
    flexure.isFound = deviation <= greatestMeanDeviation;
    flexure.confidence = flexure.isFound ? confidences[k] : 0.0;
    if (!flexure.isFound)
    {
      flexure.reason = "no bend where anatomy has this flexure";
    }
  }
}

void
FindPublished(const CentrelineShape & shape, ColonFlexures & result)
{
  const std::array<int, 4> places = PublishedFlexures(shape);
  const VertexMatrix       tangents = shape.Tangents(10.0);
  int                      previous = -1;
  for (int k = 0; k < 4; ++k)
  {
    ColonFlexure & flexure = result.flexures[k];
    if (places[k] < 0)
    {
      flexure.reason = "the published rule has no bend for it";
    }
    else if (places[k] <= previous)
    {
      flexure.reason = "the bend that the published rule takes lies out of anatomical order";
    }
    else
    {
      PlaceFlexure(shape, tangents, places[k], flexure);
      flexure.isFound = true;
      previous = places[k];
    }
  }
  const double confidence = result.NumberFound() == 4 ? 0.5 : 0.25;
  for (ColonFlexure & flexure : result.flexures)
  {
    flexure.confidence = flexure.isFound ? confidence : 0.0;
  }
}

void
WarnOfFlexures(ColonFlexures & result)
{
  const std::string & reason = result.flexures[0].reason;
  const bool          isOneReason = std::all_of(
    result.flexures.begin(), result.flexures.end(), [&](const ColonFlexure & f) { return f.reason == reason; });
  if (isOneReason && !reason.empty())
  {
    result.warnings.push_back("no flexure was found: " + reason);
    return;
  }
  for (const ColonFlexure & flexure : result.flexures)
  {
    const std::string name = "the " + NameOfFlexure(flexure.number) + " flexure";
    if (!flexure.isFound)
    {
      result.warnings.push_back(name + " was not found: " + flexure.reason);
    }
    else if (flexure.confidence < 0.5 && result.rule == FlexureRule::Ordered)
    {
      result.warnings.push_back(name + " is uncertain (confidence " +
                                std::to_string(static_cast<int>(100.0 * flexure.confidence)) + " %): look at it");
    }
  }
}
} // namespace

int
ColonFlexures::NumberFound() const
{
  return static_cast<int>(
    std::count_if(flexures.begin(), flexures.end(), [](const ColonFlexure & f) { return f.isFound; }));
}

std::string
NameOfFlexure(int number)
{
  static const char * const names[] = { "", "rectosigmoid", "descending-sigmoid", "splenic", "hepatic" };
  return number >= 1 && number <= 4 ? names[number] : "";
}

std::string
NameOf(FlexureRule rule)
{
  return rule == FlexureRule::Ordered ? "ordered" : "published";
}

ColonFlexures
FindColonFlexures(const CurveSet & centreline, FlexureRule rule)
{
  const CentrelineShape shape(centreline);
  ColonFlexures         result;
  result.rule = rule;
  for (int k = 0; k < 4; ++k)
  {
    result.flexures[k].number = k + 1;
  }
  if (shape.Length() < leastColon)
  {
    for (ColonFlexure & flexure : result.flexures)
    {
      flexure.reason = "the centreline is " + std::to_string(static_cast<int>(shape.Length() / 10.0)) +
                       " cm long, a part of a colon (a whole one has 80 cm at least)";
    }
  }
  else
  {
    rule == FlexureRule::Ordered ? FindOrdered(shape, result) : FindPublished(shape, result);
  }
  WarnOfFlexures(result);
  return result;
}
} // namespace itk
