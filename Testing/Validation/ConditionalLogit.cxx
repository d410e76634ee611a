#include "ConditionalLogit.h"

#include <algorithm>
#include <cmath>

namespace
{
/** Moments of the terms of a set under its probabilities, of all or only the right alternatives. */
struct Moments
{
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

Moments
MomentsOf(const ChoiceSet & set, const Eigen::VectorXd & weights, bool onlyRight)
{
  const auto      number = weights.size();
  const double    greatest = weights.dot(set.terms[set.Best(weights)]);
  double          sum = 0.0;
  Eigen::VectorXd first = Eigen::VectorXd::Zero(number);
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(number, number);
  for (std::size_t i = 0; i < set.terms.size(); ++i)
  {
    if (set.isRight[i] != 0 || !onlyRight)
    {
      const double share = std::max(std::exp(weights.dot(set.terms[i]) - greatest), 1e-300);
      sum += share;
      first += share * set.terms[i];
      second += share * set.terms[i] * set.terms[i].transpose();
    }
  }
  first /= sum;
  return { first, second / sum - first * first.transpose() };
}

/** Variances of the terms over all alternatives. */
Eigen::VectorXd
Variances(const std::vector<ChoiceSet> & sets)
{
  const auto      number = sets.front().terms.front().size();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(number);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(number);
  double          alternatives = 0.0;
  for (const ChoiceSet & set : sets)
  {
    for (const Eigen::VectorXd & terms : set.terms)
    {
      sum += terms;
      squares += terms.cwiseAbs2();
      alternatives += 1.0;
    }
  }
  return squares / alternatives - (sum / alternatives).cwiseAbs2();
}
} // namespace

std::size_t
ChoiceSet::Best(const Eigen::VectorXd & weights) const
{
  const auto best = std::max_element(
    terms.begin(), terms.end(), [&](const auto & a, const auto & b) { return weights.dot(a) < weights.dot(b); });
  return best - terms.begin();
}

Eigen::VectorXd
FitConditionalLogit(const std::vector<ChoiceSet> & sets, double penalty)
{
  // The logarithm of the probability of the right ones is replaced by its tangent, which bounds the loss from above;
  // Newton steps of this convex bound.
  constexpr int         iterations = 300;
  const Eigen::VectorXd penalties = 2.0 * penalty * Variances(sets);
  Eigen::VectorXd       weights = Eigen::VectorXd::Zero(penalties.size());
  double                importance = 0.0;
  for (const ChoiceSet & set : sets)
  {
    importance += set.importance;
  }
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    Eigen::VectorXd gradient = penalties.cwiseProduct(weights);
    Eigen::MatrixXd hessian = penalties.asDiagonal();
    for (const ChoiceSet & set : sets)
    {
      const Moments all = MomentsOf(set, weights, false);
      gradient += set.importance / importance * (all.mean - MomentsOf(set, weights, true).mean);
      hessian += set.importance / importance * all.covariance;
    }
    weights -= hessian.ldlt().solve(gradient);
  }
  return weights;
}
