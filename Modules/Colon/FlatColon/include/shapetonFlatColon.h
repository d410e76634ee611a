#ifndef shapetonFlatColon_h
#define shapetonFlatColon_h

#include "shapetonFlatColonAxis.h"
#include "shapetonFlatColonGrid.h"
#include "shapetonSmoothedCurvature.h"

#include <memory>
#include <string>

namespace shapeton
{
/** \class FlatColon
 * \brief The flat wall of a colon with its derived data, computed on demand and cached.
 *
 * The surface is a flat tube from FlattenTube() (see FlatColonGrid). Grids, axes and curvatures are cached for the
 * lifetime of the object. Thread-safe; results do not depend on the order of calls.
 *
 * Grid(), Axis() and Curvature() throw the exceptions of FlatColonGrid, MakeFlatColonAxis() and
 * SmoothedMeanCurvature().
 *
 * \ingroup ShapetonFlatColon */
class ShapetonFlatColon_EXPORT FlatColon
{
public:
  /** \param options of the grid used by folds, taeniae and registration.
   * \param what name of the surface in messages. */
  explicit FlatColon(SurfaceMesh                  surface,
                     const FlatColonGridOptions & options = {},
                     std::string                  what = "the flat surface");
  ~FlatColon();

  const SurfaceMesh &
  Surface() const
  {
    return m_Surface;
  }
  /** The grid used by folds, taeniae and registration. */
  const FlatColonGrid &
  Grid() const
  {
    return this->Grid(m_Options);
  }
  /** A grid with other options, such as for a picture. */
  const FlatColonGrid &
  Grid(const FlatColonGridOptions & options) const;
  /** Axis of Grid() or of the grid with the given options, smoothed over a fifth of the circumference. */
  const FlatColonAxis &
  Axis() const
  {
    return this->Axis(m_Options);
  }
  const FlatColonAxis &
  Axis(const FlatColonGridOptions & options) const;
  /** Curvature of the tube with the cut closed, after heat diffusion for `time` mm^2, indexed by
   * FlatColonGrid::SourceOfPoints(). With PerArea, folds are positive for either orientation of the faces. */
  const Eigen::VectorXd &
  Curvature(double time, CurvatureUnit unit = CurvatureUnit::PerArea) const;

private:
  struct Derived;

  SurfaceMesh              m_Surface;
  FlatColonGridOptions     m_Options;
  std::string              m_What;
  std::unique_ptr<Derived> m_Derived;
};
} // namespace shapeton

#endif
