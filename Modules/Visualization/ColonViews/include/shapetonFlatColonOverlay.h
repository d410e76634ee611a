#ifndef shapetonFlatColonOverlay_h
#define shapetonFlatColonOverlay_h

#include "ShapetonColonViewsExport.h"

#include "shapetonColonAssessability.h"
#include "shapetonFlatColonGrid.h"
#include "shapetonPicture.h"

#include <functional>
#include <vector>

namespace shapeton
{
/** Labels on the flat map, drawn as outlines. \ingroup ShapetonColonViews */
struct FlatOutlines
{
  /** Label image on any grid of the same map, `columns` per row; not owned. */
  const unsigned short * labels{ nullptr };
  int                    columns{ 0 };
  int                    rows{ 0 };
  /** Color of a label; never called for 0. */
  std::function<RGBColor(int)> colorOf;
  /** Outline thickness in pixels of the strip. */
  int thickness{ 2 };
};

/** A line on the flat map. \ingroup ShapetonColonViews */
struct FlatLine
{
  /** (u, v), mm; consecutive points are connected the shorter way around the tube. A non-finite point breaks the
   * line. */
  std::vector<Eigen::Vector2d> places;
  RGBColor                     color;
  /** Line thickness in pixels of the strip. */
  double thickness{ 2.0 };
};

/** A dot on the flat map. \ingroup ShapetonColonViews */
struct FlatDot
{
  Eigen::Vector2d uv{ Eigen::Vector2d::Zero() };
  RGBColor        color;
  /** Radius in pixels of the strip. */
  double radius{ 2.5 };
};

/** \defgroup FlatColonOverlay Overlays drawn on a strip (see FlatColonStrip) before page layout
 * All of them wrap around the tube. The strip must have the size of the grid, else std::invalid_argument is thrown.
 * \ingroup ShapetonColonViews */
///@{
/** Draws the pixels inside a label that are next to its border. */
ShapetonColonViews_EXPORT void
DrawFlatOutlines(Picture * strip, const FlatColonGrid & grid, const FlatOutlines & outlines);

ShapetonColonViews_EXPORT void
DrawFlatLine(Picture * strip, const FlatColonGrid & grid, const FlatLine & line);

/** Draws dots with a dark rim. */
ShapetonColonViews_EXPORT void
DrawFlatDot(Picture * strip, const FlatColonGrid & grid, const FlatDot & dot);

/** Hatches the columns whose distances along the centerline (mm, one per column) are in sections that cannot be
 * assessed. Without distances nothing is drawn. */
ShapetonColonViews_EXPORT void
DrawFlatHatching(Picture *                            strip,
                 const FlatColonGrid &                grid,
                 const std::vector<double> &          distanceOfColumns,
                 const std::vector<HinderedStretch> & stretches);

/** Samples a curve in space at most every `step` mm, and maps each sample to the flat map by its nearest surface point.
 * A result is non-finite where the surface is more than `farthest` mm away. */
ShapetonColonViews_EXPORT std::vector<Eigen::Vector2d>
                          PlacesOfCurve(const FlatColonGrid &                grid,
                                        const std::vector<Eigen::Vector3d> & points,
                                        double                               step = 2.0,
                                        double                               farthest = 15.0);
///@}
} // namespace shapeton

#endif
