#ifndef shapetonFlatColonPage_h
#define shapetonFlatColonPage_h

#include "ShapetonColonViewsExport.h"

#include "shapetonFlatColonGrid.h"
#include "shapetonPictureAnnotation.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** An annotation of a position. \ingroup ShapetonColonViews */
struct FlatAnnotation
{
  enum class Kind
  {
    /** Start of a colon segment; the text is its name. Only the position along the colon matters. */
    Segment,
    /** A ring of `diameter`. */
    Polyp,
    /** A small cross, for example where a handle was. */
    Mark
  };
  Kind        kind{ Kind::Mark };
  std::string text;
  /** \name Position: exactly one of these */
  ///@{
  /** mm of the map. */
  std::optional<Eigen::Vector2d> uv{};
  /** LPS, mm; moved to the nearest point of the wall. */
  std::optional<Eigen::Vector3d> point{};
  /** mm along the centerline; for segments only. */
  std::optional<double> distance{};
  ///@}
  /** Diameter of a polyp on the surface, mm. */
  double diameter{ 6.0 };
};

/** Title, rows and margins of a page that shows the flat colon row by row. See FlatColonPage.
 * \ingroup ShapetonColonViews */
struct FlatColonPageOptions
{
  std::string title;
  /** Text below the title; lines end with \n. */
  std::string note;
  /** Maximum length of a row, pixels. */
  int greatestColumns{ 1500 };
  /** Maximum length (pixels) of a section that is bridged all around and hence interpolated; longer sections are
   * shortened, with a break in the strip, because a conformal map enlarges such narrow places. 0 shows all. */
  int longestBridge{ 60 };
  /** Fraction of the circumference that is repeated, in paler colors, above and below the picture, so that no structure
   * is cut in two. 0 to 0.5. */
  double overlap{ 0.08 };
  /** Color bar at the right of the page. */
  std::optional<ColorScale> colorBar{};
};

/** A page that shows a strip in rows.
 *
 * Below each row is a ruler with the distance along the centerline in cm; if `distanceOfColumns` is empty, the ruler
 * measures along the map. Above each row is a scale bar of round length with the row's local scale: the median, and the
 * range from 10 to 90 % of the pixels. Wall interpolated over a gap is hatched.
 *
 * Throws std::invalid_argument if the strip does not have the size of the grid, the distances do not match its columns,
 * or an annotation has no position.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawFlatColonPage(const Picture *                     strip,
                                            const FlatColonGrid &               grid,
                                            const std::vector<double> &         distanceOfColumns,
                                            const std::vector<FlatAnnotation> & annotations = {},
                                            const FlatColonPageOptions &        options = {});

/** Corresponding positions in two strips. \ingroup ShapetonColonViews */
struct FlatColonLink
{
  /** Positions (u, v) in the upper and in the lower strip, in mm on the map. */
  Eigen::Vector2d upper{ Eigen::Vector2d::Zero() };
  Eigen::Vector2d lower{ Eigen::Vector2d::Zero() };
  RGBColor        color;
};

/** Two strips to be compared. Not owned. \ingroup ShapetonColonViews */
struct FlatColonPair
{
  const Picture * upper{ nullptr };
  const Picture * lower{ nullptr };
  /** Names to the left of the strips, for example "supine" and "prone". */
  std::string upperName;
  std::string lowerName;
  /** Lines between the strips, at the columns of the positions. */
  std::vector<FlatColonLink> links;
};

/** DrawFlatColonPage() for two strips on one grid: each row shows the lower strip below the upper one, with
 * corresponding positions aligned. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawFlatColonPairPage(const FlatColonPair &               pair,
                                                const FlatColonGrid &               grid,
                                                const std::vector<double> &         distanceOfColumns,
                                                const std::vector<FlatAnnotation> & annotations = {},
                                                const FlatColonPageOptions &        options = {});
} // namespace shapeton

#endif
