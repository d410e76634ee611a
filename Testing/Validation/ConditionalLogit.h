#ifndef ConditionalLogit_h
#define ConditionalLogit_h

#include <Eigen/Dense>

#include <vector>

/** Alternatives of which one is chosen, each with terms and whether it is a right one. */
struct ChoiceSet
{
  std::vector<Eigen::VectorXd> terms;
  std::vector<char>            isRight;
  double                       importance{ 1.0 };

  /** The alternative with the greatest score. */
  std::size_t
  Best(const Eigen::VectorXd & weights) const;
};

/** Weights of the terms for which the probability of a right alternative is greatest, where the probability of an
 * alternative is proportional to e to the power of its weighted terms (McFadden 1974). Each set needs a right one.
 * \param penalty factor of the squared weights of terms in units of their standard deviations, relative to the mean
 * logarithm of the probability */
Eigen::VectorXd
FitConditionalLogit(const std::vector<ChoiceSet> & sets, double penalty);

#endif
