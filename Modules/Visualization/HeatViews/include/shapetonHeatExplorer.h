#ifndef shapetonHeatExplorer_h
#define shapetonHeatExplorer_h

#include "ShapetonHeatViewsExport.h"
#include "shapetonHeatHistogram.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatRanges.h"
#include "shapetonOutputPath.h"
#include "shapetonPageBlocks.h"
#include "shapetonShapeQuantity.h"
#include "shapetonShapeTransferFunction.h"
#include "shapetonSliceMontage.h"

#include "itkImage.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Content of the page in addition to the heat volumes. The pointers are not owned and must not be null, except
 * axisHistogram and objects. \ingroup ShapetonHeatViews */
struct HeatExplorerContent
{
  std::string           title;
  ShapeQuantity         quantity;
  const HeatHistogram * histogram{ nullptr };
  /** Histogram that defines the axis; null for the drawn one. */
  const HeatHistogram *        axisHistogram{ nullptr };
  HeatScale                    scale{ HeatScale::Equalized };
  const itk::Image<float, 3> * gray{ nullptr };
  /** Intensity window of the slices. */
  IntensityWindow window;
  /** Voxel of `gray` initially under the crosshair; by default the middle. */
  std::optional<itk::Index<3>> place;
  /** Initial lines of the page. */
  ShapeTransferFunction lines;
  /** Initially zoomed ranges; the key B closes the last one. */
  HeatRanges ranges;
  /** Objects, which are shown in color and can be selected by a click; their labels have the size of `gray`. Null for
   * none. */
  const HeatObjectList * objects{ nullptr };
};

/** \class HeatExplorer
 * \brief The page explorer.html: interactive selection of lines of the heat histogram, with slices and a rendering.
 *
 * The page opens from a file and works offline; its data are scripts in the folder `explorer` next to it. Heats are
 * stored as HeatHistogram bins, so the page has the full resolution of the histogram; objects as labels. Volumes with
 * more than 2^25 voxels are subsampled along each axis, which the page states. Equal input gives equal bytes.
 *
 * \ingroup ShapetonHeatViews */
class ShapetonHeatViews_EXPORT HeatExplorer
{
public:
  /** `folder` and its folder `explorer` must exist; `outputPath` maps final names to the names to write to. */
  HeatExplorer(const std::string & folder, const OutputPath & outputPath);

  /** Name of the data folder inside the folder of the page. */
  static const char * const DataFolder;

  /** Stores the values, in [0, 1], of a time step; steps must ascend. A step that is already stored is skipped. Throws
   * OutputError. */
  void
  AddStep(const itk::Image<float, 3> * values, std::uint64_t timeStep);

  /** Writes the page. Throws OutputError, and std::logic_error if no step was added. */
  void
  Write(const HeatExplorerContent & content);

private:
  std::string                m_Folder;
  OutputPath                 m_OutputPath;
  PageBlocks                 m_Blocks;
  std::vector<std::uint64_t> m_TimeSteps;
};
} // namespace shapeton

#endif
