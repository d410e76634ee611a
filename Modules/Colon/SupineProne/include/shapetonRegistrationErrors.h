#ifndef shapetonRegistrationErrors_h
#define shapetonRegistrationErrors_h

#include "shapetonSupineProneRegistration.h"

#include <limits>

namespace shapeton
{
/** A point of the wall in both positions, LPS, mm. \ingroup SupineProne */
struct PointPair
{
  Eigen::Vector3d source;
  Eigen::Vector3d target;
};

/** How far the map takes one point from where it should go. \ingroup SupineProne */
struct PointError
{
  enum class Kind
  {
    Counted,
    /** In an excluded stretch. */
    Excluded,
    /** More than 10 mm from one of the surfaces; there are no distances. */
    OffSurface
  };
  Kind kind{ Kind::OffSurface };
  /** Distance in space, mm, and on the flat map of the target, of which the circumference is 1. */
  double inSpace{ std::numeric_limits<double>::quiet_NaN() };
  double onMap{ std::numeric_limits<double>::quiet_NaN() };
};

/** Distances between mapped points and the points they belong to. See MeasureRegistrationErrors().
 * \ingroup SupineProne */
struct RegistrationErrors
{
  /** Of each pair that counts: distance in space, mm, and on the flat map of the target, of which the circumference is
   * 1. */
  std::vector<double> inSpace;
  std::vector<double> onMap;
  /** Pairs left aside: more than 10 mm from one of the surfaces, in an excluded stretch. */
  int offSurface{ 0 };
  int excluded{ 0 };

  SupineProne_EXPORT double
  Mean() const;
  SupineProne_EXPORT double
  Median() const;
  SupineProne_EXPORT double
  Percentile95() const;
  /** Of the distances in space that are below 10 mm. */
  SupineProne_EXPORT double
  ShareWithin10() const;
  SupineProne_EXPORT double
  MeanOnMap() const;
  /** 95 % confidence interval of the mean over stretches of neighbouring points (blocks in the order given), as errors
   * of neighbours depend on each other: mean +- this, mm. */
  SupineProne_EXPORT double
  HalfInterval() const;
};

/** How far a map between the positions of a registration takes each of the points from where it should go.
 * \ingroup SupineProne */
SupineProne_EXPORT std::vector<PointError>
                   ErrorsOfPoints(const SupineProneRegistration & registration,
                                  const CylinderMap &             map,
                                  const std::vector<PointPair> &  pairs);

/** Those that count, and how many do not. \ingroup SupineProne */
SupineProne_EXPORT RegistrationErrors
SummaryOf(const std::vector<PointError> & errors);

/** SummaryOf() ErrorsOfPoints() by the map of the registration, or by its `frame` with `measuresFrame`.
 * \ingroup SupineProne */
SupineProne_EXPORT RegistrationErrors
MeasureRegistrationErrors(const SupineProneRegistration & registration,
                          const std::vector<PointPair> &  pairs,
                          bool                            measuresFrame = false);
} // namespace shapeton

#endif
