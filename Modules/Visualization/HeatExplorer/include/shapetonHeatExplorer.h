#ifndef shapetonHeatExplorer_h
#define shapetonHeatExplorer_h

#include "HeatExplorerExport.h"
#include "shapetonHeatHistogram.h"
#include "shapetonHeatRanges.h"
#include "shapetonHtmlReport.h"
#include "shapetonPageBlocks.h"
#include "shapetonShapeQuantity.h"
#include "shapetonShapeTransferFunction.h"
#include "shapetonSliceMontage.h"

#include "itkImage.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** What the page shows besides the volumes of heat. The pointers are not owned and must not be null, but for
 * axisHistogram. \ingroup HeatExplorer */
struct HeatExplorerContent
{
  std::string           title;
  ShapeQuantity         quantity;
  const HeatHistogram * histogram{ nullptr };
  /** Lays out the axis in its place, where given. */
  const HeatHistogram *        axisHistogram{ nullptr };
  HeatScale                    scale{ HeatScale::Equalized };
  const itk::Image<float, 3> * grey{ nullptr };
  /** Grey values of the slices. */
  IntensityWindow window;
  /** The lines that the page begins with. */
  ShapeTransferFunction lines;
  /** The ranges that are opened when the page begins; B closes the last one. */
  HeatRanges ranges;
};

/** \class HeatExplorer
 * \brief The page explorer.html: lines of the heat histogram picked by hand, with slices and a rendering that follow.
 *
 * The page opens from a file and asks for no network; its data are scripts in the folder `explorer` beside it. Heats
 * are kept as the bins of HeatHistogram, so that nothing is lost that the histogram shows; of volumes with more than
 * 2^25 voxels every n-th voxel of each axis is kept, which the page says. Equal input gives equal bytes.
 *
 * \ingroup HeatExplorer */
class HeatExplorer_EXPORT HeatExplorer
{
public:
  /** `folder` and the folder `explorer` within it are there already; `outputPath` maps final names to those to write
   * to. */
  HeatExplorer(const std::string & folder, const OutputPath & outputPath);

  /** The name of the folder of the data, within that of the page. */
  static const char * const DataFolder;

  /** Stores the values, in [0, 1], of a time step; in ascending order of the steps. A step that is there already is not
   * stored again. Throws OutputError. */
  void
  AddStep(const itk::Image<float, 3> * values, std::uint64_t timeStep);

  /** Writes the page. Throws OutputError, and std::logic_error where no step was added. */
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
