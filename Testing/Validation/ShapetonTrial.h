#ifndef ShapetonTrial_h
#define ShapetonTrial_h

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonShapetonDiffusionImageFilter.h"

#include <ctime>
#include <map>
#include <string>
#include <vector>

/** A volume on which heat and shapetons are tried. */
struct TrialVolume
{
  std::string                           name;
  itk::Image<float, 3>::Pointer         image;
  itk::Image<unsigned char, 3>::Pointer labels; ///< null where no truth is known
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

/** A preset of ShapePhantom; the window reaches from the background to the greatest intensity. */
TrialVolume
MakeTrialPhantom(const std::string & preset, const itk::Size<3> & size);

/** A rule by which shapetons walk. */
struct WalkRule
{
  std::string                 name;
  shapeton::DirectionSampling sampling;
  shapeton::PathRule          path;
  shapeton::ShapetonPlacement placement;
};
/** The rule of chapter 3. */
extern const WalkRule publishedWalk;
/** The rule whose density obeys the operator of heat. */
extern const WalkRule controlledWalk;

struct WalkSettings
{
  std::uint32_t shapetons{ 65000 };
  double        distance{ 0.01 };
  std::uint64_t steps{ 2500 };
  bool          startInObjects{ false }; ///< in labelled voxels; by default anywhere
};

/** Of all cores together: hardly changed by other work on the machine, unlike the time of the clock. */
double
ProcessorSeconds(std::clock_t ticks);

/** What one method made of a volume. */
struct Trial
{
  std::string                           method;
  std::string                           settings;
  itk::Image<float, 3>::Pointer         field;          ///< heat, or visits divided by the greatest number of visits
  itk::Image<std::uint32_t, 3>::Pointer visits;         ///< null for heat
  double                                seconds{ 0.0 }; ///< see ProcessorSeconds()
  std::uint64_t                         steps{ 0 };
  shapeton::ShapetonMeasures            measures; ///< of shapetons
};

Trial
RunHeat(const TrialVolume & volume, double p, std::uint64_t steps);

Trial
RunShapetons(const TrialVolume & volume, double p, const WalkRule & rule, const WalkSettings & settings);

/** The length of a step in units of the smallest spacing, and the steps of heat with the spread of the controlled walk
 * (see shapeton::EquivalentHeatTimeSteps). */
double
StepInVoxels(const TrialVolume & volume, double distance);
std::uint64_t
MatchedHeatSteps(const TrialVolume & volume, const WalkSettings & settings);

/** Mean of the field over the voxels of each label but 0. */
std::map<int, double>
MeansOfObjects(const TrialVolume & volume, const itk::Image<float, 3> * field);

/** The share of the variance of the field over the labelled voxels that lies between the objects: 1 when each object
 * has one value of its own, 0 when all means are equal. */
double
VarianceBetweenObjects(const TrialVolume & volume, const itk::Image<float, 3> * field);

/** The classes of the field without the background, and their adjusted Rand index against the labels over the labelled
 * voxels: 1 for the same partition, 0 on average for one made by chance. */
struct ClassAgreement
{
  std::size_t classes{ 0 };
  double      adjustedRand{ 0.0 };
};
ClassAgreement
CompareClasses(const TrialVolume & volume, const Trial & trial);

/** Spearman's rank correlation; ties have their mean rank. 0 where one side is constant. */
double
RankCorrelation(const std::vector<double> & a, const std::vector<double> & b);

/** Rank correlation of two fields over the object voxels, averaged over blocks of `block` voxels along each axis that
 * hold nothing but object voxels. */
double
RankCorrelationOfFields(const TrialVolume &          volume,
                        const itk::Image<float, 3> * a,
                        const itk::Image<float, 3> * b,
                        std::size_t                  block);

/** Mean visits of the object voxels. */
double
MeanVisitsOfObjects(const TrialVolume & volume, const Trial & trial);

#endif
