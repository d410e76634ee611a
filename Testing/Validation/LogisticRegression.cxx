#include "LogisticRegression.h"

#include <algorithm>

Eigen::VectorXd
FitLogistic(const LogisticSamples & samples, const Eigen::VectorXd & penalties)
{
  const auto      rows = static_cast<Eigen::Index>(samples.terms.size());
  Eigen::MatrixXd terms(rows, penalties.size());
  for (Eigen::Index i = 0; i < rows; ++i)
  {
    terms.row(i) = samples.terms[i].transpose();
  }
  const Eigen::Map<const Eigen::ArrayXd> outcomes(samples.outcomes.data(), rows);
  const Eigen::Map<const Eigen::ArrayXd> importance(samples.importance.data(), rows);
  constexpr int                          iterations = 60;
  constexpr double longestStep = 2.0; // keeps Newton's method from leaving the range of the exponential
  Eigen::VectorXd  weights = Eigen::VectorXd::Zero(terms.cols());
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const Eigen::ArrayXd  p = 1.0 / (1.0 + (-(terms * weights).array()).exp());
    const Eigen::VectorXd residuals = importance * (outcomes - p);
    const Eigen::VectorXd curvature = importance * p * (1.0 - p);
    const Eigen::VectorXd gradient = terms.transpose() * residuals - penalties.cwiseProduct(weights);
    Eigen::MatrixXd       hessian = terms.transpose() * curvature.asDiagonal() * terms;
    hessian.diagonal() += penalties;
    const Eigen::VectorXd step = hessian.ldlt().solve(gradient);
    weights += step * std::min(1.0, longestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
  }
  return weights;
}
