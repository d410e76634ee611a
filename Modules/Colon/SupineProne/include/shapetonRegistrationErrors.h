#ifndef shapetonRegistrationErrors_h
#define shapetonRegistrationErrors_h

#include "shapetonSupineProneRegistration.h"

#include <limits>

namespace shapeton
{
/** A point of the wall in both positions, LPS, mm. \ingroup ShapetonSupineProne */
struct PointPair
{
  Eigen::Vector3d source;
  Eigen::Vector3d target;
};

/** Registration error at one point. \ingroup ShapetonSupineProne */
struct PointError
{
  enum class Kind
  {
    Counted,
    /** The point is in an excluded stretch. */
    Excluded,
    /** The point is more than 10 mm from one of the surfaces, so distances are undefined. */
    OffSurface
  };
  Kind kind{ Kind::OffSurface };
  /** Distance in space (mm), and distance on the flat map of the target relative to its circumference. */
  double inSpace{ std::numeric_limits<double>::quiet_NaN() };
  double onMap{ std::numeric_limits<double>::quiet_NaN() };
  /** ConfidenceAt() the point. */
  double confidence{ std::numeric_limits<double>::quiet_NaN() };
};

/** Distances between mapped points and their true correspondences. See MeasureRegistrationErrors().
 * \ingroup ShapetonSupineProne */
struct RegistrationErrors
{
  /** For each valid pair: distance in space (mm), and distance on the flat map of the target relative to its
   * circumference. */
  std::vector<double> inSpace;
  std::vector<double> onMap;
  /** Numbers of ignored pairs: those more than 10 mm from one of the surfaces, and those in an excluded stretch. */
  int offSurface{ 0 };
  int excluded{ 0 };

  ShapetonSupineProne_EXPORT double
  Mean() const;
  ShapetonSupineProne_EXPORT double
  Median() const;
  ShapetonSupineProne_EXPORT double
  Percentile95() const;
  /** Fraction of the distances in space below 10 mm. */
  ShapetonSupineProne_EXPORT double
  ShareWithin10() const;
  ShapetonSupineProne_EXPORT double
  MeanOnMap() const;
  /** Half width (mm) of the 95 % confidence interval of the mean, computed from blocks of consecutive points, since
   * errors of neighbors are correlated. */
  ShapetonSupineProne_EXPORT double
  HalfInterval() const;
};

/** Registration error at each point for a map between the positions of a registration.
 * \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT std::vector<PointError>
                           ErrorsOfPoints(const SupineProneRegistration & registration,
                                          const CylinderMap &             map,
                                          const std::vector<PointPair> &  pairs);

/** Collects the valid errors and counts the ignored ones. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT RegistrationErrors
SummaryOf(const std::vector<PointError> & errors);

/** Summary of ErrorsOfPoints() for the map of the registration, or for its `frame` if `measuresFrame` is set.
 * \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT RegistrationErrors
MeasureRegistrationErrors(const SupineProneRegistration & registration,
                          const std::vector<PointPair> &  pairs,
                          bool                            measuresFrame = false);
} // namespace shapeton

#endif
