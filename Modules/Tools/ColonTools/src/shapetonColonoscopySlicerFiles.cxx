#include "shapetonColonoscopyReport.h"

#include "shapetonColonLandmarkPictures.h"
#include "shapetonColorTable.h"
#include "shapetonSlicerMarkups.h"

#include <array>

namespace shapeton
{
namespace
{
constexpr std::array<double, 3> gasInSlicer{ 0.35, 0.6, 0.9 };
constexpr std::array<double, 3> fluidInSlicer{ 0.95, 0.85, 0.3 };
constexpr std::array<double, 3> ileumInSlicer{ 0.4, 0.8, 0.4 };
constexpr std::array<double, 3> colorOfCenterline{ 1.0, 0.85, 0.2 };

std::array<double, 3>
Shares(const RGBColor & color)
{
  return { color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 };
}

Markup
CenterlineMarkup(const CurveSet & centerline)
{
  constexpr double spacing = 10.0; // mm, of the control points
  Markup           markup = MarkupOfCurve(centerline, 0, Markup::Kind::Curve, spacing);
  markup.name = "centerline";
  markup.color = colorOfCenterline;
  return markup;
}

std::vector<LabelColor>
SegmentColors(const std::vector<ColonSegmentExtent> & segments)
{
  std::vector<LabelColor> colors;
  for (const ColonSegmentExtent & segment : segments)
  {
    colors.push_back({ segment.label, segment.name, Shares(ColorOfSegment(segment.label)) });
  }
  return colors;
}
} // namespace

std::vector<std::string>
WriteColonoscopySlicerFiles(const ColonoscopyResults & results,
                            const std::string &        folder,
                            const OutputPath &         outputPath)
{
  std::vector<std::string> written;
  const auto               pathOf = [&](const std::string & name) {
    written.push_back(name);
    return outputPath(folder + '/' + name);
  };
  const StageResult * const segmentation = results.Find(colonoscopystage::segmentation);
  if (segmentation && segmentation->Has(examination::lumen.name))
  {
    WriteColorTable({ { 1, "gas", gasInSlicer }, { 2, "fluid", fluidInSlicer }, { 3, "terminalIleum", ileumInSlicer } },
                    pathOf(examination::slicerLumenColors.name));
  }
  if (!results.centerline.curves.empty())
  {
    WriteMarkups({ CenterlineMarkup(results.centerline) }, pathOf(examination::slicerCenterline.name));
  }
  if (!results.segments.empty())
  {
    WriteColorTable(SegmentColors(results.segments), pathOf(examination::slicerSegmentColors.name));
  }
  return written;
}
} // namespace shapeton
