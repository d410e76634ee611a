#ifndef shapetonLevels_h
#define shapetonLevels_h

#include "shapetonFloors.h"

namespace shapeton
{
constexpr double LeastTagging = 100.0; // HU above tissue
constexpr double LeastAtEdge = 0.7;    // of the fluid's contrast, where the rise of a level is over
constexpr double StepsToFluid = 3.0;   // from a gas voxel above a level: two may lie in the rise

/** A flat part of the floor of some gas: depth = depth + slope . (place - centre), in mm along and across gravity. */
struct Level
{
  int                 gas{ 0 };     ///< the piece above it
  double              area{ 0.0 };  ///< mm^2
  double              width{ 0.0 }; ///< standard deviation along its shorter way, mm
  double              depth{ 0.0 };
  Eigen::Vector2d     slope;
  Eigen::Vector2d     centre;
  std::vector<size_t> floors;       ///< indices of the gas voxels just above it
  double              below{ 0.0 }; ///< median intensity 3 to 6 mm below it
  double              edge{ 0.0 };  ///< median intensity where a level is over and a wall is not: about 2 mm below it

  /** Of what lies below; shallow pools are brightest near the level. */
  double
  Fluid() const
  {
    return below > edge ? below : edge;
  }
  /** Bright matter lies right below, no wall in between. */
  bool
  IsTagged(double tissue) const
  {
    return this->Fluid() > tissue + LeastTagging && edge - tissue > LeastAtEdge * (this->Fluid() - tissue);
  }
};

/** The flat parts of floors, perpendicular to gravity within 6 degrees, at least 30 mm^2, the largest first. Walls are
 * curved: the bottom of a haustrum is flat on a few mm^2 only. */
std::vector<Level>
FindLevels(const ColonGrid &          grid,
           const std::vector<float> & hu,
           const std::vector<Floor> & floors,
           const Fall &               fall,
           double                     tissue);
} // namespace shapeton

#endif
