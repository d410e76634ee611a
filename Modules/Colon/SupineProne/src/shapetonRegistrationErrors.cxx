#include "shapetonRegistrationErrors.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shapeton
{
namespace
{
double
MeanOf(const std::vector<double> & values)
{
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double
Quantile(const std::vector<double> & values, double share)
{
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : NearestQuantile(values, share);
}
} // namespace

double
RegistrationErrors::Mean() const
{
  return MeanOf(inSpace);
}

double
RegistrationErrors::Median() const
{
  return Quantile(inSpace, 0.5);
}

double
RegistrationErrors::Percentile95() const
{
  constexpr double share = 0.95;
  return Quantile(inSpace, share);
}

double
RegistrationErrors::MeanOnMap() const
{
  return MeanOf(onMap);
}

double
RegistrationErrors::ShareWithin10() const
{
  constexpr double limit = 10.0; // mm
  const auto within = std::count_if(inSpace.begin(), inSpace.end(), [limit](double error) { return error < limit; });
  return inSpace.empty() ? 0.0 : static_cast<double>(within) / static_cast<double>(inSpace.size());
}

double
RegistrationErrors::HalfInterval() const
{
  constexpr std::size_t blocks = 20; // chosen: blocks, since neighboring errors are dependent
  const std::size_t     number = std::min(blocks, inSpace.size());
  std::vector<double>   means;
  for (std::size_t block = 0; block < number; ++block)
  {
    const auto begin = inSpace.begin() + static_cast<std::ptrdiff_t>(block * inSpace.size() / number);
    const auto end = inSpace.begin() + static_cast<std::ptrdiff_t>((block + 1) * inSpace.size() / number);
    means.push_back(MeanOf({ begin, end }));
  }
  if (means.size() < 2)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double mean = MeanOf(means);
  double       squares = 0.0;
  for (const double value : means)
  {
    squares += (value - mean) * (value - mean);
  }
  constexpr double student = 2.093; // 97.5 % quantile of Student's t with 19 degrees of freedom
  return student * std::sqrt(squares / (means.size() - 1.0) / static_cast<double>(means.size()));
}

std::vector<PointError>
ErrorsOfPoints(const SupineProneRegistration & registration,
               const CylinderMap &             map,
               const std::vector<PointPair> &  pairs)
{
  constexpr double        greatestDistance = 10.0; // mm from the surface
  const FlatColonLocator  source(registration.source->Grid());
  const FlatColonLocator  target(registration.target->Grid());
  const double            around = registration.target->Grid().Circumference();
  std::vector<PointError> errors(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const FlatPlace from = source.Find(pairs[i].source);
    const FlatPlace to = target.Find(pairs[i].target);
    if (from.distance > greatestDistance || to.distance > greatestDistance)
    {
      continue;
    }
    const CylinderPlace   place = registration.source->PlaceOfUv(from.uv);
    const CylinderPlace   mapped = map.Forward(place);
    const Eigen::Vector2d uv = registration.target->UvOfPlace(mapped);
    const double          du = (uv.x() - to.uv.x()) / around;
    const double          dv = TurnDifference(uv.y() / around, to.uv.y() / around);
    errors[i].kind = IsExcludedAt(registration, place) ? PointError::Kind::Excluded : PointError::Kind::Counted;
    errors[i].onMap = std::hypot(du, dv);
    errors[i].confidence = ConfidenceAt(registration, place);
    errors[i].inSpace = (registration.target->PointOfPlace(mapped) - to.surfacePoint).norm();
  }
  return errors;
}

RegistrationErrors
SummaryOf(const std::vector<PointError> & errors)
{
  RegistrationErrors summary;
  for (const PointError & error : errors)
  {
    summary.offSurface += error.kind == PointError::Kind::OffSurface;
    summary.excluded += error.kind == PointError::Kind::Excluded;
    if (error.kind == PointError::Kind::Counted)
    {
      summary.onMap.push_back(error.onMap);
      summary.inSpace.push_back(error.inSpace);
    }
  }
  return summary;
}

RegistrationErrors
MeasureRegistrationErrors(const SupineProneRegistration & registration,
                          const std::vector<PointPair> &  pairs,
                          bool                            measuresFrame)
{
  return SummaryOf(ErrorsOfPoints(registration, measuresFrame ? registration.frame : registration.map, pairs));
}
} // namespace shapeton
