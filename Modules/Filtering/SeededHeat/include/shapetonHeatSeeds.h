#ifndef shapetonHeatSeeds_h
#define shapetonHeatSeeds_h

#include "SeededHeatExport.h"
#include "shapetonSlicerMarkups.h"
#include "shapetonVolume.h"

#include "itkImage.h"

#include <string>
#include <vector>

namespace shapeton
{
using SeedImage = itk::Image<unsigned short, 3>;

/** Converts a label map read from `path` to seeds on the grid of the image. Throws InputError for another grid, and
 * for values that are not integers from 0 to 65535. \ingroup SeededHeat */
SeededHeat_EXPORT SeedImage::Pointer
                  SeedsOfVolume(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image);

/** Seeds from markups: label 1 for the first node, 2 for the second, and so on. Points mark the voxels that contain
 * them; curves mark all voxels that their straight segments pass through. Throws InputError with node and point for
 * a point outside the volume or in a voxel of another label, or for a node without a point. \ingroup SeededHeat */
SeededHeat_EXPORT SeedImage::Pointer
                  SeedsOfMarkups(const std::vector<Markup> & markups, const itk::ImageBase<3> * image);

/** Seeds from classes, such as the lines of a heat histogram (HeatClassification::labels).
 * \ingroup SeededHeat */
struct ClassSeeds
{
  /** The classes to use; empty: all but 0. */
  std::vector<int> classes;
  /** 0: all voxels of a class are seeds, with one label per class. Else this number of the largest connected
   * components (by faces) of each class, each with its own label, the largest first. */
  int components{ 0 };
};

/** Seeds are eroded by one voxel at the border of their class, unless that would remove them all. Labels count from
 * 1, in the order of the classes. Throws InputError if a chosen class has no voxel. \ingroup SeededHeat */
SeededHeat_EXPORT SeedImage::Pointer
                  SeedsOfClasses(const SeedImage * classes, const ClassSeeds & choice);
} // namespace shapeton

#endif
