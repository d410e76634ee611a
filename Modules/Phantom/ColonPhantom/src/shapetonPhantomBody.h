#ifndef shapetonPhantomBody_h
#define shapetonPhantomBody_h

#include "ColonPhantomExport.h"

#include "itkPoint.h"

#include <memory>
#include <vector>

namespace shapeton
{
/** What a body is like around a point, for samplers that skip where nothing changes.
 * \ingroup ColonPhantom */
struct BodyProbe
{
  /** Signed distance to the body's outer surface in mm, negative inside; its magnitude may be too small, never too
   * large. */
  double distance;
  /** No surface of the body, outer or inner, is nearer than this, mm. */
  double clearance;
  /** True when the intensity changes smoothly within the ball of radius `clearance`. */
  bool textured{ false };
};

/** \class PhantomBody
 * \brief A body of a CT phantom: where it is, and its intensity in HU.
 *
 * Bodies are painted in order, each over those before it.
 *
 * \ingroup ColonPhantom
 */
class ColonPhantom_EXPORT PhantomBody
{
public:
  using PointType = itk::Point<double, 3>;

  virtual ~PhantomBody();

  virtual BodyProbe
  Probe(const PointType & point) const = 0;

  /** Intensity in HU at a point of the body that lies on none of its surfaces. */
  virtual double
  Intensity(const PointType & point) const = 0;

  /** Changes `value`, the mean intensity of a cell of `width` mm around `point`, by the share of the body in it. */
  virtual void
  Paint(const PointType & point, double width, double & value) const = 0;
};

/** In the order of painting. \ingroup ColonPhantom */
using PhantomBodies = std::vector<std::shared_ptr<const PhantomBody>>;

/** The share of a cell of `width` mm that lies inside a plane face; `distance` of its centre, negative inside.
 * \ingroup ColonPhantom */
inline double
ShareInside(double distance, double width)
{
  const double share = 0.5 - distance / width;
  return share <= 0.0 ? 0.0 : (share >= 1.0 ? 1.0 : share);
}
} // namespace shapeton

#endif
