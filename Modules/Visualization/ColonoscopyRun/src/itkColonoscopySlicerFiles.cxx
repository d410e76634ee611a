#include "itkColonoscopyReport.h"

#include "itkColonoscopyPictures.h"
#include "itkColorTable.h"
#include "itkSlicerMarkups.h"

#include <algorithm>

namespace itk
{
namespace
{
std::array<double, 3>
Shares(const RGBColor & color)
{
  return { color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 };
}

Markup
CentrelineMarkup(const CurveSet & centreline)
{
  Markup markup = MarkupOfCurve(centreline, 0, Markup::Kind::Curve, 10.0);
  markup.name = "centreline";
  markup.color = { 1.0, 0.85, 0.2 };
  return markup;
}

/** Centres and ends of folds, each kind as points of one colour. */
std::vector<Markup>
FeatureMarkups(const CurveSet & features)
{
  std::vector<Markup>        markups(2);
  const SurfaceArray * const fold = FindSurfaceArray(features.cellArrays, "fold");
  const SurfaceArray * const kind = FindSurfaceArray(features.cellArrays, "kind");
  markups[0].name = "fold centres";
  markups[0].color = { 0.4, 1.0, 0.6 };
  markups[1].name = "fold ends";
  markups[1].color = { 0.3, 0.7, 1.0 };
  for (std::size_t i = 0; fold && kind && i < features.curves.size(); ++i)
  {
    const auto   row = static_cast<Eigen::Index>(i);
    const bool   isEnd = kind->values(row, 0) != 0.0;
    Markup &     markup = markups[isEnd ? 1 : 0];
    const double number = fold->values(row, 0);
    markup.points.emplace_back(features.V.row(features.curves[i].front()));
    markup.labels.push_back("fold " + std::to_string(static_cast<int>(number)));
  }
  return markups;
}

std::vector<LabelColor>
FoldColors(const std::vector<ColonoscopyFold> & folds)
{
  std::vector<LabelColor> colors;
  for (const ColonoscopyFold & fold : folds)
  {
    colors.push_back({ fold.label, "fold " + std::to_string(fold.label), ColorOfLabel(fold.label) });
  }
  return colors;
}

std::vector<LabelColor>
SegmentColors(const std::vector<ColonoscopySegment> & segments)
{
  std::vector<LabelColor> colors;
  for (const ColonoscopySegment & segment : segments)
  {
    colors.push_back({ segment.label, segment.name, Shares(ColorOfColonSegment(segment.label)) });
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
  if (results.Find(colonoscopystage::segmentation) && results.Find(colonoscopystage::segmentation)->Has("lumen.nrrd"))
  {
    WriteColorTable({ { 1, "gas", { 0.35, 0.6, 0.9 } }, { 2, "fluid", { 0.95, 0.85, 0.3 } } }, pathOf("lumen.ctbl"));
  }
  if (!results.centreline.curves.empty())
  {
    WriteMarkups({ CentrelineMarkup(results.centreline) }, pathOf("centreline.mrk.json"));
  }
  if (!results.segments.empty())
  {
    WriteColorTable(SegmentColors(results.segments), pathOf("segments.ctbl"));
  }
  if (!results.folds.empty())
  {
    WriteMarkups(FeatureMarkups(results.features), pathOf("features.mrk.json"));
    WriteColorTable(FoldColors(results.folds), pathOf("folds.ctbl"));
  }
  return written;
}
} // namespace itk
