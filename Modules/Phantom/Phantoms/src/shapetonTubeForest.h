#ifndef shapetonTubeForest_h
#define shapetonTubeForest_h

#include "shapetonPhantomSolid.h"

#include <vector>

namespace shapeton
{
/** A tapered tube with round ends; a ball if both ends coincide. LPS, mm. */
struct TaperedTube
{
  using PointType = PhantomBody::PointType;
  PointType from;
  PointType to;
  double    fromRadius;
  double    toRadius;
};

/** The union of many tubes with a spatial index. Distances are clamped to `reach` mm. */
PhantomSolid
ForestSolid(const std::vector<TaperedTube> & tubes, double reach);
} // namespace shapeton

#endif
