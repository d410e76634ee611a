#ifndef shapetonFoldPicture_h
#define shapetonFoldPicture_h

#include "shapetonHaustralFolds.h"

namespace shapeton
{
/** Data of each pixel of the flat map, in the order of the label image. */
struct FoldPicture
{
  int    columns{ 0 };
  int    rows{ 0 };
  double pixelSize{ 1.0 };
  /** Smoothed curvature: in 1/mm, positive at folds, or in the published unit, negative at folds. */
  std::vector<float> curvature;
  /** Sign of the curvature of folds: 1 or -1. */
  double sign{ 1.0 };
  /** mm on the surface per mm of the map. */
  std::vector<float> scale;
  /** Whether the pixel is on a face that is not bridged. */
  std::vector<char> isWall;
  /** Number of the part that contains the pixel, from 1; 0 if there is none. */
  std::vector<int> part;

  std::size_t
  Index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * columns + column;
  }
  std::size_t
  Size() const
  {
    return static_cast<std::size_t>(columns) * rows;
  }
  /** Area on the surface, mm^2. */
  double
  AreaOf(std::size_t pixel) const
  {
    const double side = pixelSize * scale[pixel];
    return side * side;
  }
};

FoldPicture
MakeFoldPicture(const FlatColon & flat, const HaustralFoldSettings & options);
} // namespace shapeton

#endif
