#ifndef LogisticRegression_h
#define LogisticRegression_h

#include <Eigen/Dense>

#include <vector>

/** Terms, outcome (1 or 0) and importance of each sample. */
struct LogisticSamples
{
  std::vector<Eigen::VectorXd> terms; ///< with 1 for the constant
  std::vector<double>          outcomes;
  std::vector<double>          importance;

  void
  Add(const Eigen::VectorXd & ofSample, bool outcome, double weight = 1.0)
  {
    terms.push_back(ofSample);
    outcomes.push_back(outcome ? 1.0 : 0.0);
    importance.push_back(weight);
  }
};

/** Weights of the terms that maximize the likelihood of the outcomes, by Newton's method. \param penalties factors of
 * half the squared weights, one per term; above 0 if the outcomes may be separable */
Eigen::VectorXd
FitLogistic(const LogisticSamples & samples, const Eigen::VectorXd & penalties);

#endif
