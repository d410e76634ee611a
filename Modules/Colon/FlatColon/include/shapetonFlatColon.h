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
 * \brief The flat wall of a colon and what is derived from it: made once in a run and handed on.
 *
 * The surface is a flat tube as FlattenTube() gives it (see FlatColonGrid). Grids, their axes and curvatures are made
 * when they are first asked for, and kept as long as the flat colon, so that whoever asks for the same gets the same
 * object. Several threads may ask at once; results do not depend on who was first.
 *
 * Grid(), Axis() and Curvature() throw what FlatColonGrid, MakeFlatColonAxis() and SmoothedMeanCurvature() throw.
 *
 * \ingroup FlatColon */
class FlatColon_EXPORT FlatColon
{
public:
  /** \param options of the grid in which folds, taeniae and registration work.
   * \param what names the surface in messages. */
  explicit FlatColon(SurfaceMesh                  surface,
                     const FlatColonGridOptions & options = {},
                     std::string                  what = "the flat surface");
  ~FlatColon();

  const SurfaceMesh &
  Surface() const
  {
    return m_Surface;
  }
  /** The grid in which folds, taeniae and registration work. */
  const FlatColonGrid &
  Grid() const
  {
    return this->Grid(m_Options);
  }
  /** Another one, such as for a picture. */
  const FlatColonGrid &
  Grid(const FlatColonGridOptions & options) const;
  /** Of Grid(), or of the other grid, smoothed over a fifth of the circumference. */
  const FlatColonAxis &
  Axis() const
  {
    return this->Axis(m_Options);
  }
  const FlatColonAxis &
  Axis(const FlatColonGridOptions & options) const;
  /** Of the tube without its cut, after diffusion of heat for `time` mm^2, by the numbers of
   * FlatColonGrid::SourceOfPoints(); whatever the orientation of the faces, folds are positive PerArea. */
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
