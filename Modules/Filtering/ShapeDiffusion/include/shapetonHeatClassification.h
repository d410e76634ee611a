#ifndef shapetonHeatClassification_h
#define shapetonHeatClassification_h

#include "shapetonHeatClasses.h"
#include "shapetonShapeComponents.h"

#include "itkImage.h"

#include <vector>

namespace shapeton
{
/** What counts as a class.
 * \ingroup ShapeDiffusion */
struct HeatClassificationRule
{
  /** At most so many classes besides the background; in [1, 254]. */
  unsigned int maximumNumberOfClasses{ 12 };
  /** Lines whose peak lies below this heat belong to the background: the surroundings on their way to 0. The heat of a
   * converged object is higher unless it is wider than 1500 voxels. */
  double backgroundHeat{ 0.001 };
  /** The least share of all voxels above the background that makes a class; in [0, 1]. */
  double minimumShare{ 0.0005 };
  /** Two neighbouring peaks are two classes when the lower one is at least so many times the valley between them. */
  double minimumPeakToValley{ 2.0 };
};

/** The classes of one row of a heat histogram: its peaks, cut at the valleys between them (dissertation 2.3.3:
 * converged heats are lines, similar shapes lie near each other). Ascending in heat and without gaps from the
 * background (class 0) to the greatest heat; labels count from 0, so that similar classes have
 * neighbouring labels. The row is smoothed over about half a per cent of the heat first; peaks that the rule rejects
 * join the neighbour beyond the shallower valley. voxels and meanHeat are those of the row's counts; the other measures
 * stay 0. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT std::vector<HeatClass>
FindHeatClasses(const HeatHistogram & histogram, std::size_t row, const HeatClassificationRule & rule = {});

/** The label of each voxel by its heat. Fills in the exact voxels, meanHeat, volume and borderShare of the classes.
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT itk::Image<unsigned char, 3>::Pointer
                      LabelHeat(const itk::Image<float, 3> * heat, std::vector<HeatClass> & classes);

/** Fills in components and normalizedHeat of the classes: each closed component that has converged (its heat is within
 * 5 % of its convergedHeat) counts in the class of its first voxel.
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT void
AssignComponents(const std::vector<ShapeComponent> & components,
                 const itk::Image<float, 3> *        heat,
                 std::vector<HeatClass> &            classes);

/** The classes of a heat volume and the label of each voxel.
 * \ingroup ShapeDiffusion */
struct HeatClassification
{
  std::vector<HeatClass>                classes;
  itk::Image<unsigned char, 3>::Pointer labels;
};

/** FindHeatClasses, LabelHeat and AssignComponents in one.
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT HeatClassification
ClassifyHeat(const itk::Image<float, 3> *        heat,
             const std::vector<ShapeComponent> & components = {},
             const HeatClassificationRule &      rule = {});
} // namespace shapeton

#endif
