#ifndef ObjectVolumes_h
#define ObjectVolumes_h

#include "itkImage.h"

#include <functional>
#include <string>
#include <vector>

/** A volume with reference labels; see ReferenceParts. */
struct ObjectVolume
{
  itk::Image<float, 3>::Pointer         image;
  itk::Image<unsigned char, 3>::Pointer labels;
};

/** How to make a volume. */
struct ObjectVolumeSource
{
  std::string                   name;
  std::string                   kind;       ///< "scene", "phantom" or "scan"
  bool                          isHeldBack; ///< never used to fit or choose anything
  std::function<ObjectVolume()> make;
};

/** Random scenes, phantoms of ShapePhantom without and with noise, and scans of the test data.
 *
 * The tuning half has the scenes of the seeds 1, 2, ..., and every second phantom. The held-back half has the scenes of
 * the seeds 201, 202, ..., the other phantoms, tooth, engine and upper abdomen. The labels of scans are components of
 * an intensity range after opening, and TotalSegmentator's organs.
 *
 * \param scenes number of random scenes in each half, at most 99
 * \param dataFolder folder of the test data; empty for none */
std::vector<ObjectVolumeSource>
ObjectVolumes(unsigned int scenes, const std::string & dataFolder);

#endif
