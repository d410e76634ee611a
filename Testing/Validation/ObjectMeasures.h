#ifndef ObjectMeasures_h
#define ObjectMeasures_h

#include "ReferenceParts.h"

#include "shapetonHeatParameterChoice.h"

/** Heat of an image, as by CumulativeHeatDiffusion without options. */
itk::Image<float, 3>::Pointer
AutomaticHeat(const itk::Image<float, 3> * image);

/** How well the objects of a volume show a part of it. A click selects ObjectOfClick(), or an offer. */
struct PartMeasures
{
  int    part{ 0 };
  double bestRegion{ 0.0 };   ///< Dice of the region of the tree that fits best
  double deepestClick{ 0.0 }; ///< Dice of the object that a click on the deepest voxel selects
  /** Fractions of 200 random points, two voxels inside if possible, for which the object of the click, or an object
   * that contains the point, is whole. */
  double firstClick{ 0.0 };
  double bestClimb{ 0.0 };
  /** Fraction of these points that select the same object, the most frequent one. */
  double sameObject{ 0.0 };

  /** Whether the tree has the part as a whole. */
  bool
  IsVisible() const
  {
    return bestRegion >= wholeObject;
  }
};

/** Measures of all parts. The points depend on the parts only. */
std::vector<PartMeasures>
MeasureParts(const shapeton::HeatObjectTree & tree, const ReferenceParts & parts);

/** Number of voxels of each label in each region, region by region. */
std::vector<double>
CountsOfRegions(const shapeton::PartitionTree & tree, const ReferenceParts & parts);

/** Random voxels of a part, those two voxels inside, or one voxel, or any if there are fewer than 20. */
std::vector<std::size_t>
PointsIn(int part, const ReferenceParts::Depths & depths, std::size_t number);

#endif
