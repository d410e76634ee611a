#include "shapetonTransferFunctionPicture.h"

#include "shapetonAxisTicks.h"
#include "shapetonPageColors.h"
#include "shapetonSliceChoice.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Layout, pixels. */
constexpr unsigned int pageWidth = 1200;
constexpr int          pageMargin = 16;
constexpr int          headHeight = 48;
constexpr int          renderingWidth = 860;
constexpr int          renderingHeight = 620;

std::vector<LegendEntry>
LegendWithVoxels(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction)
{
  const std::vector<std::uint64_t> voxels = CountVoxelsOfLines(heat, transferFunction);
  std::vector<LegendEntry>         legend = LegendOf(transferFunction);
  for (std::size_t line = 0; line < legend.size(); ++line)
  {
    legend[line].text += ", " + GroupedDigits(voxels[line]) + " voxels";
  }
  return legend;
}
} // namespace

std::vector<std::uint64_t>
CountVoxelsOfLines(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction)
{
  std::vector<std::uint64_t> voxels(transferFunction.GetLines().size(), 0);
  const float * const        heats = heat->GetBufferPointer();
  const std::size_t          number = heat->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < number; ++i)
  {
    const int line = transferFunction.LineOf(heats[i]);
    if (line >= 0)
    {
      ++voxels[line];
    }
  }
  return voxels;
}

Picture::Pointer
DrawTransferFunction(const itk::Image<float, 3> *  gray,
                     const itk::Image<float, 3> *  heat,
                     const ShapeTransferFunction & transferFunction,
                     const std::string &           title,
                     const IntensityWindow &       window,
                     const ShapeQuantity &         quantity,
                     const VolumeRenderer *        renderer)
{
  SliceMontageOptions slices;
  slices.width = pageWidth;
  slices.window = window;
  slices.cut = CutThroughParts(heat, transferFunction);
  const auto montage = DrawSliceMontage(gray, heat, ColorByLine(transferFunction), slices);

  constexpr double       azimuth = 25.0, elevation = 15.0; // degrees
  VolumeRenderingOptions view;
  view.azimuth = azimuth;
  view.elevation = elevation;
  view.width = renderingWidth;
  view.height = renderingHeight;
  view.focus = VisibleRegion(heat, transferFunction);
  const auto rendering = renderer ? renderer->Render(view) : RenderVolume(heat, transferFunction, view);

  const int     top = pageMargin + headHeight;
  const int     montageTop = top + renderingHeight + 8;
  auto          page = NewPicture(pageWidth, montageTop + montage->GetBufferedRegion().GetSize(1), PaperColor);
  constexpr int titleSize = 24;
  constexpr int headingSize = 17;
  TextStyle     style{ titleSize, InkColor, true };
  DrawText(page, title, pageMargin, pageMargin, style);
  PastePicture(page, rendering, pageMargin, top);
  style.size = headingSize;
  const int    legendLeft = pageMargin + renderingWidth + 16;
  const auto & lines = transferFunction.GetLines();
  const bool   isNamed = std::any_of(lines.begin(), lines.end(), [](const auto & line) { return !line.name.empty(); });
  DrawText(page,
           isNamed ? "Parts: range of " + quantity.plural : "Lines: range of " + quantity.plural,
           legendLeft,
           top,
           style);
  DrawLegend(page, LegendWithVoxels(heat, transferFunction), legendLeft, top + 32, top + renderingHeight);
  PastePicture(page, montage, 0, montageTop);
  return page;
}
} // namespace shapeton
