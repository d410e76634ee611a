#ifndef shapetonFlatColonPage_h
#define shapetonFlatColonPage_h

#include "ColonViewsExport.h"

#include "shapetonFlatColonGrid.h"
#include "shapetonPictureAnnotation.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Something to tell about a place. \ingroup ColonViews */
struct FlatAnnotation
{
  enum class Kind
  {
    /** A segment of the colon begins here; the text is its name. Only the place along the colon counts. */
    Segment,
    /** A ring of `diameter`. */
    Polyp,
    /** A small cross, for example where a handle was. */
    Mark
  };
  Kind        kind{ Kind::Mark };
  std::string text;
  /** \name The place: one of these */
  ///@{
  /** mm of the map. */
  std::optional<Eigen::Vector2d> uv;
  /** LPS, mm; goes to the nearest point of the wall. */
  std::optional<Eigen::Vector3d> point;
  /** mm along the centreline; for segments. */
  std::optional<double> distance;
  ///@}
  /** mm on the surface, of a polyp. */
  double diameter{ 6.0 };
};

/** Title, rows and margins of a page that shows the flat colon row by row. See FlatColonPage. \ingroup ColonViews */
struct FlatColonPageOptions
{
  std::string title;
  /** Below the title; lines end with \n. */
  std::string note;
  /** Pixels of the longest row. */
  int greatestColumns{ 1500 };
  /** A stretch that is bridged all around, and made up therefore, is cut short to so many pixels, with a break in the
   * strip: a conformal map gives such narrow places much room. 0 shows all. */
  int longestBridge{ 60 };
  /** The picture goes on around the tube by this share of the circumference above and below, paler, so that nothing is
   * cut in two. 0 to 0.5. */
  double overlap{ 0.08 };
  /** At the right of the page. */
  std::optional<ColorScale> colorBar;
};

/** A page with a strip in rows.
 *
 * Below each row a ruler with the distance along the centreline in cm (where it is not known, `distanceOfColumns` is
 * empty and the ruler counts along the map), above it a bar of round length with the row's local scale: the median, and
 * the range from 10 to 90 % of the pixels. Stretches of the wall that were made up over a gap are hatched.
 *
 * Throws std::invalid_argument when the strip has not the size of the grid, distances do not have its columns, or an
 * annotation has no place.
 * \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawFlatColonPage(const Picture *                     strip,
                                    const FlatColonGrid &               grid,
                                    const std::vector<double> &         distanceOfColumns,
                                    const std::vector<FlatAnnotation> & annotations = {},
                                    const FlatColonPageOptions &        options = {});

/** The same place in two strips. \ingroup ColonViews */
struct FlatColonLink
{
  /** (u, v), mm of the map of the grid, in the upper and in the lower strip. */
  Eigen::Vector2d upper{ Eigen::Vector2d::Zero() };
  Eigen::Vector2d lower{ Eigen::Vector2d::Zero() };
  RGBColor        color;
};

/** Two strips that are to be compared place by place. Nothing is owned. \ingroup ColonViews */
struct FlatColonPair
{
  const Picture * upper{ nullptr };
  const Picture * lower{ nullptr };
  /** At their left, for example "supine" and "prone". */
  std::string upperName;
  std::string lowerName;
  /** Lines from strip to strip, at the columns of their places. */
  std::vector<FlatColonLink> links;
};

/** DrawFlatColonPage() of two strips on one grid: in each row the lower one below the upper one, so that what agrees
 * lies at the same place across. \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawFlatColonPairPage(const FlatColonPair &               pair,
                                        const FlatColonGrid &               grid,
                                        const std::vector<double> &         distanceOfColumns,
                                        const std::vector<FlatAnnotation> & annotations = {},
                                        const FlatColonPageOptions &        options = {});
} // namespace shapeton

#endif
