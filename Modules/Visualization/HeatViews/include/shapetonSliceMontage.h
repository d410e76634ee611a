#ifndef shapetonSliceMontage_h
#define shapetonSliceMontage_h

#include "HeatViewsExport.h"

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
/** What a montage of slices shows.
 * \ingroup HeatViews */
struct SliceMontageOptions
{
  std::string     title;
  IntensityWindow window;
  /** The voxel that the three slices meet in; by default where most colours are seen (see DrawSliceMontage). */
  std::optional<itk::Index<3>> cut;
  std::vector<LegendEntry>     legend;
  /** Of the colours over the grey values, in [0, 1]. */
  double opacity{ 0.6 };
  /** Pixels; at least 600. */
  unsigned int width{ 1200 };
};

/** The window itself, or where it is the default, the quantiles of the image that it stands for.
 * \ingroup HeatViews */
HeatViews_EXPORT IntensityWindow
WindowOf(const itk::Image<float, 3> * grey, const IntensityWindow & window);

/** Three orthogonal slices, axial, coronal and sagittal, of the grey image with the colours of the heat over it.
 *
 * The slices follow the volume's own axes; each is shown the radiological way, as near as these axes allow (axial: the
 * patient's right at the left, anterior on top; coronal: right at the left, head on top; sagittal: anterior at the
 * left, head on top), with the true letters at its borders. All three have one scale in mm, whatever the spacing. By
 * default each axis is cut where the slice shows most different colours, then most coloured voxels, then nearest to the
 * middle.
 *
 * Throws std::invalid_argument when the images differ in size, when the cut lies outside, or when the width is too
 * small. \ingroup HeatViews */
HeatViews_EXPORT Picture::Pointer
                 DrawSliceMontage(const itk::Image<float, 3> * grey,
                                  const itk::Image<float, 3> * heat,
                                  const HeatColoring &         coloring,
                                  const SliceMontageOptions &  options = {});

/** A legend for the classes but the background: ClassColor(), number, mean value.
 * \ingroup HeatViews */
HeatViews_EXPORT std::vector<LegendEntry>
                 LegendOf(const std::vector<HeatClass> & classes, const ShapeQuantity & quantity = {});

/** A legend for the lines of a transfer function: range of heats.
 * \ingroup HeatViews */
HeatViews_EXPORT std::vector<LegendEntry>
                 LegendOf(const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
