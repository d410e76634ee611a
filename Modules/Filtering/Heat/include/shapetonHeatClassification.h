#ifndef shapetonHeatClassification_h
#define shapetonHeatClassification_h

#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonHeatClasses.h"
#include "shapetonShapeComponents.h"
#include "shapetonVolumeGradientOperator.h"

#include "itkImage.h"

#include <vector>

namespace shapeton
{
/** Criteria for classes.
 * \ingroup ShapetonHeat */
struct HeatClassificationRule
{
  /** Largest number of classes besides the background; in [1, 254]. */
  unsigned int maximumNumberOfClasses{ 12 };
  /** Lines whose peak is below this heat belong to the background: surroundings that cool toward 0. Converged objects
   * up to 1500 voxels wide are warmer. */
  double backgroundHeat{ 0.001 };
  /** Smallest fraction of all voxels above the background that forms a class; in [0, 1]. */
  double minimumShare{ 0.0005 };
  /** Two adjacent peaks are separate classes if the lower one is at least this many times the valley between them. */
  double minimumPeakToValley{ 2.0 };
};

/** Throws InputError that begins with `what` if an image has no pixels or a value outside [0, 1] (tolerance 1e-4): such
 * a volume is not a heat volume. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT void
RequireHeat(const itk::Image<float, 3> * heat, const std::string & what);

/** The classes of one row of a heat histogram: its peaks, separated at the valleys between them (dissertation 2.3.3:
 * converged heats are lines, similar shapes are close to each other). Classes are ascending in heat and contiguous
 * from the background (class 0) to the greatest heat; labels count from 0, so similar classes have adjacent labels.
 * The row is first smoothed over about half a percent of the heat; peaks rejected by the rule are merged across the
 * shallower valley. voxels and meanHeat follow from the counts of the row; the other measures remain 0.
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::vector<HeatClass>
FindHeatClasses(const HeatHistogram & histogram, std::size_t row, const HeatClassificationRule & rule = {});

/** Sets the coherence of the classes of `heat` (one value per voxel) and counts the regions that they show.
 *
 * The coherence is the conductance inside the class, minus three times the conductance to other classes, relative to
 * the conductance of the same voxels if there were no edges; at least 0. It is near 1 for a region bounded by edges,
 * and near 0 for speckle of insulated voxels. Two classes are bands of heat in one region if the mean conductance
 * between them is more than half of that without edges. Returns the sum, over the regions, of the largest coherence of
 * a class in the region; classes with less than 5 % of the voxels are weighted in proportion to the square root of
 * their size. The result does not depend on the number of threads. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT double
MeasureCoherence(const VolumeGradientOperator & volumeGradient, const float * heat, std::vector<HeatClass> & classes);

/** The label of each voxel by its heat. Sets the exact voxels, meanHeat, volume, borderShare and isSurroundings of
 * the classes.
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT itk::Image<unsigned char, 3>::Pointer
                    LabelHeat(const itk::Image<float, 3> * heat, std::vector<HeatClass> & classes);

/** Sets the coherence of the classes from labels alone, for volumes without edge weights: the share of the faces of its
 * voxels that are between two voxels of the class, minus the share of the others; at least 0. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT void
MeasureContiguity(const itk::Image<unsigned char, 3> * labels, std::vector<HeatClass> & classes);

/** Sets components and normalizedHeat of the classes: each closed converged component (heat within 5 % of its
 * convergedHeat) counts in the class of its first voxel.
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT void
AssignComponents(const std::vector<ShapeComponent> & components,
                 const itk::Image<float, 3> *        heat,
                 std::vector<HeatClass> &            classes);

/** The classes of a heat volume and the label of each voxel.
 * \ingroup ShapetonHeat */
struct HeatClassification
{
  std::vector<HeatClass>                classes;
  itk::Image<unsigned char, 3>::Pointer labels;
};

/** The classes found by a run with WantComponents, with labels and components. Throws ParameterError if the run found
 * none, and as RequireHeat(). \ingroup ShapetonHeat */
ShapetonHeat_EXPORT HeatClassification
ClassifyHeat(const itk::Image<float, 3> * heat, const CumulativeHeatDiffusionResult & result);

/** FindHeatClasses, LabelHeat and AssignComponents in one call. Throws as RequireHeat().
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT HeatClassification
ClassifyHeat(const itk::Image<float, 3> *        heat,
             const std::vector<ShapeComponent> & components = {},
             const HeatClassificationRule &      rule = {});
} // namespace shapeton

#endif
