#ifndef shapetonStableRegions_h
#define shapetonStableRegions_h

#include "shapetonComponentTree.h"
#include "shapetonHeatObjects.h"

namespace shapeton
{
/** A node of a component tree: the voxels [first, end) of its list. */
struct StableRegion
{
  ComponentTree::Index first, end;
  double               growth, range; ///< as in HeatObject
};

/** Logarithm of a heat or density; values below a millionth of `greatest` count as a millionth. */
double
LogHeat(float value, float greatest);

/** Stable nodes with at least options.leastVoxels voxels and at most options.mostShare of the volume; those of one path
 * differ in size by a factor of 1.3 or more. In the order of the tree. */
std::vector<StableRegion>
FindStableRegions(const ComponentTree & tree, const float * values, float greatest, const HeatObjectOptions & options);
} // namespace shapeton

#endif
