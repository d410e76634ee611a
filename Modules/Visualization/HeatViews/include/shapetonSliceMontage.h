#ifndef shapetonSliceMontage_h
#define shapetonSliceMontage_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatColoring.h"
#include "itkImage.h"
#include "shapetonPicture.h"
#include "shapetonPictureAnnotation.h"
#include "shapetonShapeQuantity.h"
#include "shapetonSliceView.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Options of a montage of slices.
 * \ingroup ShapetonHeatViews */
struct SliceMontageOptions
{
  std::string     title;
  IntensityWindow window;
  /** Intersection voxel of the three slices, for example CutThroughParts(); by default the middle. */
  std::optional<itk::Index<3>> cut{};
  std::vector<LegendEntry>     legend{};
  /** Opacity of the colors over the gray values, in [0, 1]. */
  double opacity{ 0.6 };
  /** Pixels; at least 600. */
  unsigned int width{ 1200 };
};

/** Returns the window; for the default window, the image quantiles that it represents.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT IntensityWindow
WindowOf(const itk::Image<float, 3> * gray, const IntensityWindow & window);

/** Three orthogonal slices, axial, coronal and sagittal, of the gray image with the colors of the heat over it.
 *
 * The slices follow the volume's own axes, in the radiological convention as closely as these axes allow (axial: the
 * patient's right at the left, anterior on top; coronal: right at the left, head on top; sagittal: anterior at the
 * left, head on top), with the true letters at the borders. All three share one scale in mm, independent of the
 * spacing.
 *
 * Throws std::invalid_argument if the images differ in size, the cut is outside, or the width is too small.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT Picture::Pointer
                         DrawSliceMontage(const itk::Image<float, 3> * gray,
                                          const itk::Image<float, 3> * heat,
                                          const HeatColoring &         coloring,
                                          const SliceMontageOptions &  options = {});

/** A legend for the classes except the background: ColorOfClass() and NameOfClass(), white for those that are
 * incoherent. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::vector<LegendEntry>
                         LegendOf(const std::vector<HeatClass> & classes);

/** A legend for the lines of a transfer function: color, white if transparent, and name or heat range.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::vector<LegendEntry>
                         LegendOf(const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
