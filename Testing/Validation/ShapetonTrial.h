#ifndef ShapetonTrial_h
#define ShapetonTrial_h

#include "Times.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticlePreset.h"
#include "shapetonShapeScene.h"

#include <map>
#include <string>
#include <vector>

/** Volume used to compare heat and shapetons. */
struct TrialVolume
{
  std::string                           name;
  itk::Image<float, 3>::Pointer         image;
  itk::Image<unsigned char, 3>::Pointer labels; ///< null if the truth is unknown
  /** Intensities that map to 0 and 1. Voxels above `lower` are the object voxels. */
  double lower{ 0.0 };
  double upper{ 1.0 };

  std::size_t
  GetNumberOfVoxels() const
  {
    return image->GetLargestPossibleRegion().GetNumberOfPixels();
  }
  bool
  IsObject(std::size_t voxel) const
  {
    return image->GetBufferPointer()[voxel] > lower;
  }
};

/** Generates a scene; the window ranges from the background to the greatest intensity. */
TrialVolume
MakeTrialScene(const std::string & name, const shapeton::ShapeScene & scene, const itk::Size<3> & size);

/** Generates a preset of ShapePhantom. */
TrialVolume
MakeTrialPhantom(const std::string & preset, const itk::Size<3> & size);

/** Walk rule of shapetons. */
struct WalkRule
{
  std::string                 name;
  shapeton::DirectionSampling sampling;
  shapeton::PathRule          path;
  shapeton::ParticlePlacement placement;
};
/** Rule of chapter 3. */
extern const WalkRule publishedWalk;
/** Rule with a density that follows the heat operator. */
extern const WalkRule controlledWalk;

struct WalkSettings
{
  std::uint32_t shapetons{ 65000 };
  double        distance{ 0.01 };
  std::uint64_t steps{ 2500 };
  bool          startInObjects{ false }; ///< start in labeled voxels; by default anywhere
};

/** Result of one method on a volume. */
struct Trial
{
  std::string                           method;
  std::string                           settings;
  itk::Image<float, 3>::Pointer         field;          ///< heat, or visits divided by the greatest number of visits
  itk::Image<std::uint32_t, 3>::Pointer visits;         ///< null for heat
  double                                seconds{ 0.0 }; ///< see Stopwatch::ProcessorSeconds()
  std::uint64_t                         steps{ 0 };
  shapeton::ParticleMeasures            measures; ///< of shapetons
};

Trial
RunHeat(const TrialVolume & volume, double p, std::uint64_t steps);

Trial
RunShapetons(const TrialVolume & volume, double p, const WalkRule & rule, const WalkSettings & settings);

/** Step length in units of the smallest spacing, and the number of heat steps with the same spread as the controlled
 * walk (see shapeton::EquivalentHeatTimeSteps). */
double
StepInVoxels(const TrialVolume & volume, double distance);
std::uint64_t
MatchedHeatSteps(const TrialVolume & volume, const WalkSettings & settings);

/** Mean of the field over the voxels of each nonzero label. */
std::map<int, double>
MeansOfObjects(const TrialVolume & volume, const itk::Image<float, 3> * field);

/** Variance between objects as a fraction of the variance of the field over the labeled voxels: 1 if each object has a
 * constant value, 0 if all means are equal. */
double
VarianceBetweenObjects(const TrialVolume & volume, const itk::Image<float, 3> * field);

/** Classes of the field without the background, and their adjusted Rand index against the labels over the labeled
 * voxels: 1 for identical partitions, 0 on average for random ones. */
struct ClassAgreement
{
  std::size_t classes{ 0 };
  double      adjustedRand{ 0.0 };
};
ClassAgreement
CompareClasses(const TrialVolume & volume, const Trial & trial);

/** Spearman's rank correlation; ties have their mean rank. 0 if one side is constant. */
double
RankCorrelation(const std::vector<double> & a, const std::vector<double> & b);

/** Rank correlation of two fields, averaged over blocks of `block` voxels along each axis that contain only object
 * voxels. */
double
RankCorrelationOfFields(const TrialVolume &          volume,
                        const itk::Image<float, 3> * a,
                        const itk::Image<float, 3> * b,
                        std::size_t                  block);

/** Mean visits of the object voxels. */
double
MeanVisitsOfObjects(const TrialVolume & volume, const Trial & trial);

#endif
