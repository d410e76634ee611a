#ifndef shapetonFlatColonOverlay_h
#define shapetonFlatColonOverlay_h

#include "ColonViewsExport.h"

#include "shapetonColonAssessability.h"
#include "shapetonFlatColonGrid.h"
#include "shapetonPicture.h"

#include <functional>
#include <vector>

namespace shapeton
{
/** Labels on the flat map, to be drawn as outlines. \ingroup ColonViews */
struct FlatOutlines
{
  /** Of any grid on the same map, `columns` to a row; not owned. */
  const unsigned short * labels{ nullptr };
  int                    columns{ 0 };
  int                    rows{ 0 };
  /** Of a label; 0 is never asked for. */
  std::function<RGBColor(int)> colorOf;
  /** Pixels of the strip. */
  int thickness{ 2 };
};

/** A line on the flat map. \ingroup ColonViews */
struct FlatLine
{
  /** (u, v), mm; from place to place the shorter way around the tube is taken. A place that is not finite breaks the
   * line. */
  std::vector<Eigen::Vector2d> places;
  RGBColor                     color;
  /** Pixels of the strip. */
  double thickness{ 2.0 };
};

/** A dot on the flat map. \ingroup ColonViews */
struct FlatDot
{
  Eigen::Vector2d uv{ Eigen::Vector2d::Zero() };
  RGBColor        color;
  /** Pixels of the strip. */
  double radius{ 2.5 };
};

/** \defgroup FlatColonOverlay What is drawn over a strip (see FlatColonStrip) before it goes to a page
 * All of them go on around the tube. The strip must have the size of the grid, else std::invalid_argument.
 * \ingroup ColonViews */
///@{
/** Pixels inside of a label that are next to its border. */
ColonViews_EXPORT void
DrawFlatOutlines(Picture * strip, const FlatColonGrid & grid, const FlatOutlines & outlines);

ColonViews_EXPORT void
DrawFlatLine(Picture * strip, const FlatColonGrid & grid, const FlatLine & line);

/** With a dark rim. */
ColonViews_EXPORT void
DrawFlatDot(Picture * strip, const FlatColonGrid & grid, const FlatDot & dot);

/** Slanted lines over the columns whose distances along the centreline (mm, one for each column) lie in stretches that
 * cannot be assessed. Without distances nothing is drawn. */
ColonViews_EXPORT void
DrawFlatHatching(Picture *                            strip,
                 const FlatColonGrid &                grid,
                 const std::vector<double> &          distanceOfColumns,
                 const std::vector<HinderedStretch> & stretches);

/** The places on the map of a curve in space, by the nearest points of the surface, at most `step` mm apart; not finite
 * where the surface is more than `farthest` mm away. */
ColonViews_EXPORT std::vector<Eigen::Vector2d>
                  PlacesOfCurve(const FlatColonGrid &                grid,
                                const std::vector<Eigen::Vector3d> & points,
                                double                               step = 2.0,
                                double                               farthest = 15.0);
///@}
} // namespace shapeton

#endif
