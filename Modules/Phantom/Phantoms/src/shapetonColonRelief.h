#ifndef shapetonColonRelief_h
#define shapetonColonRelief_h

#include "shapetonColonCurve.h"
#include "shapetonColonPhantomParameters.h"
#include "shapetonColonPlan.h"

#include <vector>

namespace shapeton
{
/** A value with its derivatives with respect to the curve parameter t and the angle. */
struct ReliefValue
{
  double value;
  double byT;
  double byAngle;
};

/** The crest of a fold in a position. */
struct FoldCourse
{
  static constexpr int    Knots = 40; // of a crest; chosen
  static constexpr double End = 1.12; ///< limit of u beyond which the fold vanishes

  double angle;
  double halfAngle;
  double halfThickness;
  double height; ///< mm, maximum in this position
  bool   isFlattened;
  float  t[Knots + 3];
  float  crest[Knots + 3]; ///< mm from the centerline

  /** Returns false beyond the ends. */
  bool
  At(double u, ReliefValue & t, ReliefValue & crest) const;
};

/** Rotation of the tube about its centerline in this position, in radians, at each step of the curve. */
std::vector<double>
ColonTwist(const ColonPlan & plan, const ColonPhantomParameters & parameters);

/** \class ColonRelief
 * \brief The wall in a position: radius as a function of curve parameter and angle, and the folds.
 *
 * Radii are a cubic B-spline over a grid of half steps of the curve and of 128 angles. */
class ColonRelief
{
public:
  static constexpr int Angles = 128; // of the grid; chosen

  /** Without a curve the colon is straight; with a curve, the wall avoids the center of sharp bends. */
  ColonRelief(const ColonPlan & plan, const ColonPhantomParameters & parameters, const ColonCurve * curve);

  /** Radius (mm) of the wall without folds; negative where collapsed. */
  ReliefValue
  RadiusAt(double t, double angle) const;
  /** Mean radius over the angles. */
  double
  MeanRadiusAt(double t) const;
  /** Maximum radius within the step. */
  double
  LargestRadiusNear(int step) const;
  /** Degree of collapse, 0 (open) to 1. */
  double
  CollapseAt(double t) const;

  const std::vector<FoldCourse> &
  GetFolds() const
  {
    return m_Folds;
  }
  /** The folds that may be within reach of this position. */
  const std::vector<int> &
  FoldsNear(double t) const;

private:
  void
  FillCollapse(const ColonPlan & plan, const ColonPhantomParameters & parameters);
  void
  FillBase(const ColonPlan & plan, const ColonPhantomParameters & parameters);
  std::vector<double>
  FoldPlaces(const ColonPlan & plan, const ColonPhantomParameters & parameters) const;
  void
  FillTable(const ColonPlan & plan, const std::vector<double> & places, const ColonPhantomParameters & parameters);
  void
  RelieveBends(const ColonCurve & curve, double longestChord);
  double
  Waist(const ColonPlan & plan, const std::vector<double> & places, double material, double angle) const;
  void
  SumUpRows();
  void
  LayFolds(const ColonPlan & plan, const std::vector<double> & places, const ColonPhantomParameters & parameters);

  int                           m_Steps;
  double                        m_Step;
  int                           m_Rows;
  std::vector<double>           m_Collapse; ///< at each step
  std::vector<double>           m_Base;     ///< at each row
  std::vector<float>            m_Table;    ///< rows, with one additional row at each end
  std::vector<double>           m_Mean;
  std::vector<double>           m_Largest;
  std::vector<FoldCourse>       m_Folds;
  std::vector<std::vector<int>> m_FoldsNear;
  std::vector<std::vector<int>> m_PlansNear; ///< for construction, in bins of 10 mm of material length
};
} // namespace shapeton

#endif
