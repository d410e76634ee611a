#include "shapetonFoldMatching.h"

#include "shapetonDualDecomposition.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace shapeton
{
namespace
{
double
Around(double y, double from, double turn)
{
  const double turns = (y - from) / turn + 0.5;
  return (turns - std::floor(turns) - 0.5) * turn;
}

double
Square(double value)
{
  return value * value;
}

void
RequireValid(const FoldMatchingOptions & options, double turn)
{
  for (const double value : { turn,
                              options.reachAlong,
                              options.reachAround,
                              options.deviationAlong,
                              options.deviationAround,
                              options.deviationLength,
                              options.deviationArea,
                              options.pairDeviation })
  {
    RequireParameter(value > 0.0, "reach and deviations of the fold matching must be greater than 0");
  }
  RequireParameter(options.alone >= 0.0 && options.pairWeight >= 0.0 && options.truncation >= 0.0 &&
                     options.iterations >= 1 && options.neighbors >= 0,
                   "costs of the fold matching must not be negative, and iterations must be at least 1");
}

AssignmentProblem
MakeProblem(const std::vector<FoldFeature> & source,
            const std::vector<FoldFeature> & target,
            double                           turn,
            const FoldMatchingOptions &      options)
{
  AssignmentProblem problem;
  problem.rowAlone.assign(source.size(), options.alone);
  problem.columnAlone.assign(target.size(), options.alone);
  for (const FoldFeature & a : source)
  {
    problem.candidates.emplace_back();
    for (std::size_t j = 0; j < target.size(); ++j)
    {
      const FoldFeature & b = target[j];
      const double        along = b.x - a.x;
      const double        around = Around(b.y, a.y, turn);
      if (a.group == b.group && std::abs(along) < options.reachAlong && std::abs(around) < options.reachAround)
      {
        const double cost = Square(along / options.deviationAlong) + Square(around / options.deviationAround) +
                            Square(std::log(b.length / a.length) / options.deviationLength) +
                            Square(std::log(b.area / a.area) / options.deviationArea);
        problem.candidates.back().push_back({ static_cast<int>(j), cost });
      }
    }
  }
  return problem;
}

/** Pairs of neighboring folds. */
std::set<std::pair<int, int>>
Neighbors(const std::vector<FoldFeature> & folds, double turn, int number)
{
  std::set<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < folds.size(); ++i)
  {
    std::vector<std::pair<double, int>> others;
    for (std::size_t j = 0; j < folds.size(); ++j)
    {
      if (j != i)
      {
        others.push_back(
          { Square(folds[j].x - folds[i].x) + Square(Around(folds[j].y, folds[i].y, turn)), static_cast<int>(j) });
      }
    }
    const auto taken = std::min<std::size_t>(number, others.size());
    std::partial_sort(others.begin(), others.begin() + taken, others.end());
    for (std::size_t k = 0; k < taken; ++k)
    {
      pairs.insert(std::minmax(static_cast<int>(i), others[k].second));
    }
  }
  return pairs;
}

/** Energy of the matching without pairs, minus its energy. */
double
SavedEnergy(const AssignmentProblem & problem, double energy)
{
  const auto sum = [](const std::vector<double> & costs) { return std::accumulate(costs.begin(), costs.end(), 0.0); };
  return sum(problem.rowAlone) + sum(problem.columnAlone) - energy;
}

FoldMatching
MatchingOf(const AssignmentProblem & problem, const PairedAssignment & solved)
{
  FoldMatching matching;
  matching.primal = solved.assignment.cost;
  matching.bound = solved.bound;
  matching.iterations = solved.iterations;
  matching.savable = SavedEnergy(problem, matching.primal);
  for (std::size_t i = 0; i < problem.candidates.size(); ++i)
  {
    const int choice = solved.assignment.choice[i];
    if (choice >= 0)
    {
      matching.pairs.emplace_back(static_cast<int>(i), problem.candidates[i][choice].column);
      matching.costs.push_back(problem.candidates[i][choice].cost);
    }
  }
  return matching;
}

FoldMatching
SolveWithoutPairs(const AssignmentProblem & problem)
{
  PairedAssignment solved;
  solved.assignment = SolveAssignment(problem);
  solved.bound = solved.assignment.cost;
  solved.iterations = 1;
  return MatchingOf(problem, solved);
}

std::vector<PairTerm>
MakePairs(const AssignmentProblem &        problem,
          const std::vector<FoldFeature> & source,
          const std::vector<FoldFeature> & target,
          double                           turn,
          const FoldMatchingOptions &      options)
{
  std::vector<PairTerm> terms;
  for (const auto & [i, j] : Neighbors(source, turn, options.neighbors))
  {
    const auto & ofFirst = problem.candidates[i];
    const auto & ofSecond = problem.candidates[j];
    PairTerm     term{ i, j, Eigen::MatrixXd::Zero(ofFirst.size() + 1, ofSecond.size() + 1) };
    for (std::size_t a = 0; a < ofFirst.size(); ++a)
    {
      for (std::size_t b = 0; b < ofSecond.size(); ++b)
      {
        const FoldFeature & p = target[ofFirst[a].column];
        const FoldFeature & q = target[ofSecond[b].column];
        const double        along = (p.x - source[i].x) - (q.x - source[j].x);
        const double        around = Around(p.y, source[i].y, turn) - Around(q.y, source[j].y, turn);
        const double        square = (Square(along) + Square(around)) / Square(options.pairDeviation);
        term.cost(a, b) = options.pairWeight * std::min(square, options.truncation);
      }
    }
    terms.push_back(std::move(term));
  }
  return terms;
}
} // namespace

FoldMatching
MatchFolds(const std::vector<FoldFeature> & source,
           const std::vector<FoldFeature> & target,
           double                           turn,
           const FoldMatchingOptions &      options)
{
  RequireValid(options, turn);
  const AssignmentProblem problem = MakeProblem(source, target, turn, options);
  if (options.method == FoldMatchingMethod::DualDecomposition)
  {
    return MatchingOf(
      problem, SolvePairedAssignment(problem, MakePairs(problem, source, target, turn, options), options.iterations));
  }
  return SolveWithoutPairs(problem);
}

FoldMatching
MatchFeaturePoints(const std::vector<FeaturePoint> & source,
                   const std::vector<FeaturePoint> & target,
                   double                            turn,
                   double                            lambda)
{
  RequireParameter(turn > 0.0 && lambda > 0.0 && lambda < 1.0, "lambda must be between 0 and 1, and a turn positive");
  const FoldMatchingOptions neighborhood;
  AssignmentProblem         problem;
  problem.rowAlone.assign(source.size(), 0.0);
  for (const FeaturePoint & q : target)
  {
    problem.columnAlone.push_back((1.0 - lambda) * Square(q.fromCenter));
  }
  for (const FeaturePoint & p : source)
  {
    problem.candidates.emplace_back();
    for (std::size_t j = 0; j < target.size(); ++j)
    {
      const double along = target[j].x - p.x;
      const double around = Around(target[j].y, p.y, turn);
      if (p.group == target[j].group && std::abs(along) < neighborhood.reachAlong &&
          std::abs(around) < neighborhood.reachAround)
      {
        problem.candidates.back().push_back({ static_cast<int>(j), lambda * (Square(along) + Square(around)) });
      }
    }
  }
  return SolveWithoutPairs(problem);
}
} // namespace shapeton
