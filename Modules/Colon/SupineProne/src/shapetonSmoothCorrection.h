#ifndef shapetonSmoothCorrection_h
#define shapetonSmoothCorrection_h

#include "shapetonColonCylinder.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Prescribed displacement of a place of the source, mm along and around the target. */
struct DisplacementConstraint
{
  CylinderPlace   place;
  Eigen::Vector2d displacement;
  double          weight{ 1.0 };
};

/** Constraint on one component of a displacement: direction . displacement = value (mm). Around the tube for a taenia,
 * along the gradient for a picture. */
struct DirectionConstraint
{
  CylinderPlace   place;
  Eigen::Vector2d direction;
  double          value{ 0.0 };
  /** 1 / variance. */
  double weight{ 0.0 };
  /** Whether it is down-weighted like other constraints if it contradicts them. */
  bool isRobust{ false };
};

struct SmoothCorrectionOptions
{
  /** Node distance along the colon, mm, and number of nodes around. */
  double step{ 10.0 };
  int    angles{ 24 };
  /** Standard deviation of a constraint, mm. */
  double deviation{ 3.0 };
  /** Errors beyond this are down-weighted (Cauchy), mm. */
  double robust{ 8.0 };
  int    iterations{ 4 };
  /** Weight of the integral of the squared Laplacian, mm^2. */
  double stiffness{ 2.0 };
  /** Weight of the integral of the squared gradient, which limits extrapolation. */
  double tension{ 0.01 };
};

/** A smooth field of displacements on a cylinder: thin plate under tension, periodic around, robust by iteratively
 * reweighted least squares. */
class SmoothCorrection
{
public:
  SmoothCorrection(double begin, double end, double around, const SmoothCorrectionOptions & options = {});

  /** Returns the final weight of each constraint, in (0, 1], times its own. */
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
  Eigen::VectorXd         m_Values; ///< values along of all nodes, then around
};
} // namespace shapeton

#endif
