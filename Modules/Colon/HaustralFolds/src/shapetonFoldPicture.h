#ifndef shapetonFoldPicture_h
#define shapetonFoldPicture_h

#include "shapetonHaustralFolds.h"

namespace shapeton
{
/** What is known of each pixel of the flat map, row by row as in the label picture. */
struct FoldPicture
{
  int    columns{ 0 };
  int    rows{ 0 };
  double pixelSize{ 1.0 };
  /** After smoothing; 1/mm, positive at folds, or in the published unit, where they are negative. */
  std::vector<float> curvature;
  /** 1, or -1 where folds are negative. */
  double sign{ 1.0 };
  /** mm on the surface for each mm of the map. */
  std::vector<float> scale;
  /** A face lies there, which was not made up. */
  std::vector<char> isWall;
  /** The number, from 1 on, of the part that the pixel belongs to; 0 for none. */
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
  /** mm^2 on the surface. */
  double
  AreaOf(std::size_t pixel) const
  {
    const double side = pixelSize * scale[pixel];
    return side * side;
  }
};

FoldPicture
MakeFoldPicture(const FlatColon & flat, const HaustralFoldOptions & options);
} // namespace shapeton

#endif
