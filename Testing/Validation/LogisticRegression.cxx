#include "LogisticRegression.h"

#include <algorithm>

Eigen::VectorXd
FitLogistic(const Eigen::MatrixXd & terms,
            const Eigen::VectorXd & outcomes,
            const Eigen::VectorXd & importance,
            const Eigen::VectorXd & penalties)
{
  constexpr int    iterations = 60;
  constexpr double longestStep = 2.0; // keeps Newton's method from leaving the range of the exponential
  Eigen::VectorXd  weights = Eigen::VectorXd::Zero(terms.cols());
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const Eigen::ArrayXd  p = 1.0 / (1.0 + (-(terms * weights).array()).exp());
    const Eigen::VectorXd residuals = importance.array() * (outcomes.array() - p);
    const Eigen::VectorXd curvature = importance.array() * p * (1.0 - p);
    const Eigen::VectorXd gradient = terms.transpose() * residuals - penalties.cwiseProduct(weights);
    Eigen::MatrixXd       hessian = terms.transpose() * curvature.asDiagonal() * terms;
    hessian.diagonal() += penalties;
    const Eigen::VectorXd step = hessian.ldlt().solve(gradient);
    weights += step * std::min(1.0, longestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
  }
  return weights;
}
