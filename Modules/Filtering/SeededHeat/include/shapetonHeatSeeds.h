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

/** Seeds from a label map that was read from `path`: on the grid of the image. Throws InputError for another grid, and
 * for values that are no whole numbers from 0 to 65535. \ingroup SeededHeat */
SeededHeat_EXPORT SeedImage::Pointer
                  SeedsOfVolume(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image);

/** Seeds from markups: label 1 for the first node, 2 for the second, and so on. Points mark the voxels that they lie
 * in, curves all voxels that their straight pieces pass, as a stroke. Throws InputError that names node and point:
 * outside the volume, in a voxel of another label, or a node without a point. \ingroup SeededHeat */
SeededHeat_EXPORT SeedImage::Pointer
                  SeedsOfMarkups(const std::vector<Markup> & markups, const itk::ImageBase<3> * image);

/** Seeds of classes, such as the lines of a heat histogram (HeatClassification::labels).
 * \ingroup SeededHeat */
struct ClassSeeds
{
  /** The classes to take; empty: all but 0. */
  std::vector<int> classes;
  /** 0: all voxels of a class are seeds, of one label for each class. Else so many of the largest connected components
   * (faces) of each class, of a label each, the largest first. */
  int components{ 0 };
};

/** Seeds keep off the border of their class by one voxel, unless nothing would be left of them. Labels count from 1, in
 * the order of the classes. Throws InputError where a chosen class has no voxel. \ingroup SeededHeat */
SeededHeat_EXPORT SeedImage::Pointer
                  SeedsOfClasses(const SeedImage * classes, const ClassSeeds & choice);
} // namespace shapeton

#endif
