#ifndef shapetonSmoothCorrection_h
#define shapetonSmoothCorrection_h

#include "shapetonColonCylinder.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Prescribed displacement of a source position, mm along and around the target. */
struct DisplacementConstraint
{
  CylinderPlace   place;
  Eigen::Vector2d displacement;
  double          weight{ 1.0 };
};

/** Constraint on one component of a displacement: direction . displacement = value (mm). The direction is around the
 * tube for taeniae and along the gradient for pictures. */
struct DirectionConstraint
{
  CylinderPlace   place;
  Eigen::Vector2d direction;
  double          value{ 0.0 };
  /** 1 / variance. */
  double weight{ 0.0 };
  /** Whether the constraint is down-weighted if it contradicts others. */
  bool isRobust{ false };
};

struct SmoothCorrectionOptions
{
  /** Distance between nodes along the colon, mm, and number of nodes around it. */
  double step{ 10.0 };
  int    angles{ 24 };
  /** Standard deviation of a constraint, mm. */
  double deviation{ 3.0 };
  /** Scale of the Cauchy weight for errors, mm. */
  double robust{ 8.0 };
  int    iterations{ 4 };
  /** Weight of the integral of the squared Laplacian, mm^2. */
  double stiffness{ 2.0 };
  /** Weight of the integral of the squared gradient, which limits extrapolation. */
  double tension{ 0.01 };
};

/** A smooth field of displacements on a cylinder: a thin plate under tension, periodic around the cylinder, made robust
 * by iteratively reweighted least squares. */
class SmoothCorrection
{
public:
  SmoothCorrection(double begin, double end, double around, const SmoothCorrectionOptions & options = {});

  /** Fits the field; returns, for each constraint, the final weight in (0, 1] times the weight of the constraint. */
  std::vector<double>
  Fit(const std::vector<DisplacementConstraint> & constraints,
      const std::vector<DirectionConstraint> &    directions,
      const Progress &                            progress);

  /** Displacement, mm along and around. */
  Eigen::Vector2d
  At(const CylinderPlace & place) const;

private:
  struct Stencil
  {
    int    node[4];
    double share[4];
  };
  Stencil
  StencilAt(const CylinderPlace & place) const;
  void
  Solve(const std::vector<DisplacementConstraint> & constraints,
        const std::vector<double> &                 weights,
        const std::vector<DirectionConstraint> &    directions,
        const std::vector<double> &                 directionWeights,
        const Progress &                            progress);

  SmoothCorrectionOptions m_Options;
  double                  m_Begin;
  double                  m_Around;
  int                     m_Rows;
  Eigen::VectorXd         m_Values; ///< values along for all nodes, then values around
};
} // namespace shapeton

#endif
