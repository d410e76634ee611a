#ifndef SeedTrial_h
#define SeedTrial_h

#include "shapetonHeatSeeds.h"

#include <optional>
#include <string>
#include <vector>

/** A volume whose labels are known. */
struct LabelledVolume
{
  using ImageType = itk::Image<float, 3>;

  std::string                  name;
  ImageType::Pointer           image; ///< in [0, 1]
  shapeton::SeedImage::Pointer truth; ///< 1 to the number of names
  std::vector<std::string>     names; ///< of the labels; the first one is the background
};

/** Seeds of all labels. */
struct DrawnSeeds
{
  shapeton::SeedImage::Pointer image;
  /** Labels of which the truth less its outermost voxels holds too few voxels, so that seeds lie at the border, too. */
  int thinLabels{ 0 };
};

/** So many voxels of each label at random, from the truth eroded by one voxel: `draw` decides which. */
DrawnSeeds
DrawSeeds(const LabelledVolume & volume, int number, unsigned int draw);

/** What a method makes of seeds. */
struct Segmentation
{
  shapeton::SeedImage::Pointer labels;
  double                       cpuSeconds{ 0.0 };
  bool                         hasConverged{ true };
};

/** SeededHeatSegmentationImageFilter with its defaults. */
Segmentation
SegmentByHeat(const LabelledVolume & volume, const shapeton::SeedImage * seeds);

/** ITK's MorphologicalWatershedFromMarkers on the gradient magnitude. */
Segmentation
SegmentByWatershed(const LabelledVolume & volume, const shapeton::SeedImage * seeds);

/** ITK's ConfidenceConnected with its defaults, once for each label. A voxel that several labels reach has the one
 * whose region's mean is nearest to it; one that none reaches is background. */
Segmentation
SegmentByConfidence(const LabelledVolume & volume, const shapeton::SeedImage * seeds);

/** scikit-image's random_walker with its defaults, once for each seed image, as many at a time as there are
 * processors; nothing where python3-skimage is missing. Throws std::runtime_error where it fails. */
std::optional<std::vector<Segmentation>>
SegmentByRandomWalker(const LabelledVolume & volume, const std::vector<shapeton::SeedImage::Pointer> & seeds);

/** The probabilities of the labels with seeds, by scikit-image's random_walker with this beta and tolerance; nothing
 * where python3-skimage is missing. */
std::optional<std::vector<LabelledVolume::ImageType::Pointer>>
RandomWalkerProbabilities(const LabelledVolume & volume, const shapeton::SeedImage * seeds, double beta, double tol);

/** Of each label: 2 |A and B| / (|A| + |B|). */
std::vector<double>
DiceOfLabels(const LabelledVolume & volume, const shapeton::SeedImage * labels);

#endif
