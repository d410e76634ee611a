#ifndef shapetonHeatSeeds_h
#define shapetonHeatSeeds_h

#include "ShapetonHeatExport.h"

#include "itkImage.h"

#include <vector>

namespace shapeton
{
using SeedImage = itk::Image<unsigned short, 3>;

/** Seeds from classes, such as the lines of a heat histogram (HeatClassification::labels).
 * \ingroup ShapetonHeat */
struct ClassSeeds
{
  /** The classes to use; empty for all except 0. */
  std::vector<int> classes;
  /** 0: all voxels of a class are seeds, with one label per class. Otherwise, the number of components per class to
   * use: the largest face-connected ones, each with its own label, largest first. */
  int components{ 0 };
};

/** Seeds are eroded by one voxel at the border of their class, unless that would remove them all. Labels count from 1,
 * in the order of the classes. Throws InputError if a chosen class has no voxels. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT SeedImage::Pointer
                    SeedsOfClasses(const SeedImage * classes, const ClassSeeds & choice);
} // namespace shapeton

#endif
