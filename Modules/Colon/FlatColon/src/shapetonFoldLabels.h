#ifndef shapetonFoldLabels_h
#define shapetonFoldLabels_h

#include "shapetonFoldPicture.h"

namespace shapeton
{
/** The pixels of one fold in row-major order. */
using FoldPixels = std::vector<FlatPixel>;

/** 8-connected components, periodic in rows, ordered by their first pixels. */
std::vector<FoldPixels>
ConnectedFolds(const FoldPicture & picture, const std::vector<char> & mask);
} // namespace shapeton

#endif
