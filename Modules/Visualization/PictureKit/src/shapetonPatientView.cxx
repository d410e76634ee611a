#include "shapetonPatientView.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
// Fraction of the picture filled by the volume.
constexpr double filled = 0.88;

/** Exact for multiples of 90 degrees, so views along the axes sample voxel centers. */
double
SineOfDegrees(double degrees)
{
  constexpr double threeQuarters = 270.0;
  const double     turned = degrees - 360.0 * std::floor(degrees / 360.0);
  if (turned == 0.0 || turned == 180.0)
  {
    return 0.0;
  }
  return turned == 90.0 ? 1.0 : turned == threeQuarters ? -1.0 : std::sin(turned * itk::Math::pi_over_180);
}

double
CosineOfDegrees(double degrees)
{
  return SineOfDegrees(degrees + 90.0);
}

itk::ImageBase<3>::PointType
PointAt(const itk::ImageBase<3> * volume, const itk::ImageRegion<3> & region, const double share[3])
{
  itk::ContinuousIndex<double, 3> index;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    index[axis] = region.GetIndex(axis) - 0.5 + share[axis] * region.GetSize(axis);
  }
  itk::ImageBase<3>::PointType point;
  volume->TransformContinuousIndexToPhysicalPoint(index, point);
  return point;
}
} // namespace

void
LookFrom(PatientSide side, PatientViewOptions & options)
{
  constexpr double azimuths[] = { 0.0, 90.0, 180.0, -90.0, 0.0, 0.0 };
  constexpr double elevations[] = { 0.0, 0.0, 0.0, 0.0, 90.0, -90.0 };
  options.azimuth = azimuths[static_cast<int>(side)];
  options.elevation = elevations[static_cast<int>(side)];
}

std::string
NameOf(PatientSide side)
{
  constexpr const char * names[] = { "anterior", "left", "posterior", "right", "superior", "inferior" };
  return names[static_cast<int>(side)];
}

PatientView::PatientView(const itk::ImageBase<3> *   volume,
                         const itk::ImageRegion<3> & focus,
                         const PatientViewOptions &  options)
{
  this->TurnTo(options);
  const double middle[3] = { 0.5, 0.5, 0.5 };
  m_Center = PointAt(volume, focus, middle);
  double halfWidth = 0.0;
  double halfHeight = 0.0;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    const double     share[3] = { corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0 };
    const VectorType offset = PointAt(volume, focus, share) - m_Center;
    halfWidth = std::max(halfWidth, std::fabs(offset * m_Right));
    halfHeight = std::max(halfHeight, std::fabs(offset * m_Up));
  }
  this->FitTo(halfWidth, halfHeight, options);
}

PatientView::PatientView(const PointType &          center,
                         double                     halfWidth,
                         double                     halfHeight,
                         const PatientViewOptions & options)
  : m_Center(center)
{
  this->TurnTo(options);
  this->FitTo(halfWidth, halfHeight, options);
}

void
PatientView::TurnTo(const PatientViewOptions & options)
{
  if (!(std::fabs(options.elevation) <= 90.0 && options.zoom > 0.0) || options.width == 0 || options.height == 0)
  {
    throw std::invalid_argument(
      "the elevation of a view must be from -90 to 90 degrees, zoom and size must be positive");
  }
  m_MiddleX = 0.5 * (options.width - 1.0);
  m_MiddleY = 0.5 * (options.height - 1.0);
  const double sineOfAzimuth = SineOfDegrees(options.azimuth);
  const double cosineOfAzimuth = CosineOfDegrees(options.azimuth);
  const double sineOfElevation = SineOfDegrees(options.elevation);
  const double cosineOfElevation = CosineOfDegrees(options.elevation);
  m_Forward[0] = -sineOfAzimuth * cosineOfElevation;
  m_Forward[1] = cosineOfAzimuth * cosineOfElevation;
  m_Forward[2] = -sineOfElevation;
  m_Right[0] = cosineOfAzimuth;
  m_Right[1] = sineOfAzimuth;
  m_Right[2] = 0.0;
  m_Up = itk::CrossProduct(m_Right, m_Forward);
}

void
PatientView::FitTo(double halfWidth, double halfHeight, const PatientViewOptions & options)
{
  m_MillimetersPerPixel =
    2.0 * std::max(halfWidth / options.width, halfHeight / options.height) / (filled * options.zoom);
}

itk::Point<double, 2>
PatientView::Project(const PointType & point) const
{
  const VectorType      offset = point - m_Center;
  itk::Point<double, 2> place;
  place[0] = m_MiddleX + (offset * m_Right) / m_MillimetersPerPixel;
  place[1] = m_MiddleY - (offset * m_Up) / m_MillimetersPerPixel;
  return place;
}

PatientView::PointType
PatientView::PointOfPixel(double x, double y) const
{
  return m_Center + m_Right * ((x - m_MiddleX) * m_MillimetersPerPixel) +
         m_Up * ((m_MiddleY - y) * m_MillimetersPerPixel);
}
} // namespace shapeton
