#ifndef itkFlatColonOverlay_h
#define itkFlatColonOverlay_h

#include "FlatColonViewExport.h"

#include "itkFlatColonGrid.h"
#include "itkPicture.h"

#include <vector>

namespace itk
{
/** A line on the flat map, for example a taenia. \ingroup FlatColonView */
struct FlatCurve
{
  /** mm of the map; each step takes the shorter way around the tube. */
  std::vector<Eigen::Vector2d> uv;
  RGBColor                     color{ MakeColor(255, 255, 255) };
  /** Pixels. */
  double width{ 2.0 };
};

/** What is drawn over a flat picture: outlines of regions, such as folds, then lines. \ingroup FlatColonView */
struct FlatColonOverlay
{
  /** 0 outside; its physical points are (u, v) in mm, as those of a FlatCoordinateMap. Not owned; may be null. */
  const Image<unsigned short, 2> * regions{ nullptr };
  RGBColor                         regionColor{ MakeColor(120, 255, 160) };
  std::vector<FlatCurve>           curves;
};

/** Draws onto a strip with the pixels of the grid; what leaves it above comes back below. Throws std::invalid_argument
 * when the strip has not the size of the grid. \ingroup FlatColonView */
FlatColonView_EXPORT void
PaintFlatOverlay(Picture * strip, const FlatColonGrid & grid, const FlatColonOverlay & overlay);
} // namespace itk

#endif
