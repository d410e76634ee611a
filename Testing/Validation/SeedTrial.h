#ifndef SeedTrial_h
#define SeedTrial_h

#include "shapetonHeatSeeds.h"

#include <optional>
#include <string>
#include <vector>

/** Volume with known labels. */
struct LabeledVolume
{
  using ImageType = itk::Image<float, 3>;

  std::string                  name;
  ImageType::Pointer           image; ///< scaled to [0, 1]
  shapeton::SeedImage::Pointer truth; ///< labels from 1 to the number of names
  std::vector<std::string>     names; ///< names of the labels; the first one is the background
};

/** Seeds of all labels. */
struct DrawnSeeds
{
  shapeton::SeedImage::Pointer image;
  /** Number of labels that are too thin for enough seeds after erosion by one voxel; their seeds are also placed at
   * the border. */
  int thinLabels{ 0 };
};

/** Draws `number` random voxels of each label from the truth eroded by one voxel; `draw` selects the random numbers. */
DrawnSeeds
DrawSeeds(const LabeledVolume & volume, int number, unsigned int draw);

/** Result of a method. */
struct Segmentation
{
  shapeton::SeedImage::Pointer labels;
  double                       cpuSeconds{ 0.0 };
  bool                         hasConverged{ true };
};

/** Segments with SeededHeatSegmentationImageFilter and its defaults. */
Segmentation
SegmentByHeat(const LabeledVolume & volume, const shapeton::SeedImage * seeds);

/** Segments with ITK's MorphologicalWatershedFromMarkers on the gradient magnitude. */
Segmentation
SegmentByWatershed(const LabeledVolume & volume, const shapeton::SeedImage * seeds);

/** Segments with ITK's ConfidenceConnected and its defaults, once per label. Voxels reached by several labels get the
 * label with the nearest region mean; unreached voxels are background. */
Segmentation
SegmentByConfidence(const LabeledVolume & volume, const shapeton::SeedImage * seeds);

/** Segments with scikit-image's random_walker and its defaults, once per seed image, in parallel on all processors;
 * empty if python3-skimage is not installed. Throws std::runtime_error on failure. */
std::optional<std::vector<Segmentation>>
SegmentByRandomWalker(const LabeledVolume & volume, const std::vector<shapeton::SeedImage::Pointer> & seeds);

/** Probabilities of the seeded labels from scikit-image's random_walker with this beta and tolerance; empty if
 * python3-skimage is not installed. */
std::optional<std::vector<LabeledVolume::ImageType::Pointer>>
RandomWalkerProbabilities(const LabeledVolume & volume, const shapeton::SeedImage * seeds, double beta, double tol);

/** Dice coefficient of each label, 2 |A and B| / (|A| + |B|). */
std::vector<double>
DiceOfLabels(const LabeledVolume & volume, const shapeton::SeedImage * labels);

#endif
