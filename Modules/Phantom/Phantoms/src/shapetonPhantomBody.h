#ifndef shapetonPhantomBody_h
#define shapetonPhantomBody_h

#include "ShapetonPhantomsExport.h"

#include "itkPoint.h"

#include <memory>
#include <vector>

namespace shapeton
{
/** Properties of a body around a point, for samplers that skip uniform regions. \ingroup ShapetonPhantoms */
struct BodyProbe
{
  /** Signed distance (mm) to the outer surface of the body, negative inside; its magnitude is a lower bound. */
  double distance;
  /** Lower bound of the distance to any surface of the body, outer or inner, mm. */
  double clearance;
  /** Whether the intensity varies (smoothly) within the ball of radius `clearance`; otherwise it is constant there. */
  bool textured{ false };
};

/** \class PhantomBody
 * \brief A body of a CT phantom: region and intensity in HU.
 *
 * Bodies are painted in order, each over the previous ones.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT PhantomBody
{
public:
  using PointType = itk::Point<double, 3>;

  virtual ~PhantomBody();

  virtual BodyProbe
  Probe(const PointType & point) const = 0;

  /** Intensity (HU) at a point of the body away from its surfaces. */
  virtual double
  Intensity(const PointType & point) const = 0;

  /** Blends the body into `value`, the mean intensity of a cell of `width` mm around `point`. */
  virtual void
  Paint(const PointType & point, double width, double & value) const = 0;
};

/** In painting order. \ingroup ShapetonPhantoms */
using PhantomBodies = std::vector<std::shared_ptr<const PhantomBody>>;

/** Fraction of a cell of `width` mm inside a plane face; `distance` of its center is negative inside.
 * \ingroup ShapetonPhantoms */
inline double
ShareInside(double distance, double width)
{
  const double share = 0.5 - distance / width;
  return share <= 0.0 ? 0.0 : (share >= 1.0 ? 1.0 : share);
}
} // namespace shapeton

#endif
