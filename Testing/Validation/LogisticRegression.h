#ifndef LogisticRegression_h
#define LogisticRegression_h

#include <Eigen/Dense>

/** Weights of the terms (one column each; a column of ones for the constant) that maximize the likelihood of the
 * outcomes (1 or 0), by Newton's method. \param importance of each row \param penalties of half the squared weights,
 * one per term; above 0 if the outcomes may be separable */
Eigen::VectorXd
FitLogistic(const Eigen::MatrixXd & terms,
            const Eigen::VectorXd & outcomes,
            const Eigen::VectorXd & importance,
            const Eigen::VectorXd & penalties);

#endif
