#ifndef shapetonSmoothCorrection_h
#define shapetonSmoothCorrection_h

#include "shapetonColonCylinder.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** A place of the source is to move by so much more, mm along and around the target. */
struct DisplacementConstraint
{
  CylinderPlace   place;
  Eigen::Vector2d displacement;
  double          weight{ 1.0 };
};

/** Only what a displacement has along a direction is known: direction . displacement = value (mm). Around the tube for
 * a taenia, along the gradient for a picture. */
struct DirectionConstraint
{
  CylinderPlace   place;
  Eigen::Vector2d direction;
  double          value{ 0.0 };
  /** 1 / variance. */
  double weight{ 0.0 };
  /** Loses its weight as other constraints do where it contradicts them. */
  bool isRobust{ false };
};

struct SmoothCorrectionOptions
{
  /** Distance of the nodes along the colon, mm, and their number around. */
  double step{ 10.0 };
  int    angles{ 24 };
  /** Of a constraint, mm. */
  double deviation{ 3.0 };
  /** Errors beyond this lose their weight (Cauchy), mm. */
  double robust{ 8.0 };
  int    iterations{ 4 };
  /** Of the integral of the squared Laplacian, mm^2. */
  double stiffness{ 2.0 };
  /** Of the integral of the squared gradient: beyond the constraints the plate does not swing away. */
  double tension{ 0.01 };
};

/** A smooth field of displacements on a cylinder: thin plate under tension, periodic around, robust by iteratively
 * reweighted least squares. */
class SmoothCorrection
{
public:
  SmoothCorrection(double begin, double end, double around, const SmoothCorrectionOptions & options = {});

  /** Returns the weight that each constraint has in the end, in (0, 1], times its own. */
  std::vector<double>
  Fit(const std::vector<DisplacementConstraint> & constraints,
      const std::vector<DirectionConstraint> &    directions,
      const Progress &                            progress);

  /** mm along and around. */
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
  Eigen::VectorXd         m_Values; ///< along of all nodes, then around
};
} // namespace shapeton

#endif
