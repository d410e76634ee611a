#ifndef shapetonFoldLabels_h
#define shapetonFoldLabels_h

#include "shapetonFoldPicture.h"

namespace shapeton
{
/** The pixels of one fold, in the order of rows and columns. */
using FoldPixels = std::vector<FlatPixel>;

/** Connected components with eight neighbors per pixel, periodic in rows, ordered by their first pixels. */
std::vector<FoldPixels>
ConnectedFolds(const FoldPicture & picture, const std::vector<char> & mask);
} // namespace shapeton

#endif
