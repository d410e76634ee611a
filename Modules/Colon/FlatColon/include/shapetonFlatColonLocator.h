#ifndef shapetonFlatColonLocator_h
#define shapetonFlatColonLocator_h

#include "shapetonFlatColonGrid.h"
#include "shapetonSurfaceLocator.h"

namespace shapeton
{
/** A point in space projected to the flat map. \ingroup ShapetonFlatColon */
struct FlatPlace
{
  FlatPixel pixel;
  /** Position on the map, mm; v in [0, circumference). */
  Eigen::Vector2d uv{ Eigen::Vector2d::Zero() };
  /** Nearest point of the surface, LPS, mm. */
  Eigen::Vector3d surfacePoint{ Eigen::Vector3d::Zero() };
  /** Distance from the point to the surface, mm. */
  double distance{ 0.0 };
  int    face{ -1 };
};

/** \class FlatColonLocator
 * \brief Projects points in space to the flat map, using the nearest point of the surface.
 *
 * The grid must outlive the locator. Thread-safe.
 * \ingroup ShapetonFlatColon */
class ShapetonFlatColon_EXPORT FlatColonLocator
{
public:
  explicit FlatColonLocator(const FlatColonGrid & grid);
  ~FlatColonLocator();

  FlatPlace
  Find(const Eigen::Vector3d & point) const;

private:
  const FlatColonGrid & m_Grid;
  SurfaceLocator        m_Surface;
};
} // namespace shapeton

#endif
