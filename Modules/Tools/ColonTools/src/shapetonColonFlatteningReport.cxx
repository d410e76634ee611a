#include "shapetonColonFlatteningReport.h"

#include "shapetonColonFigures.h"
#include "shapetonCsvTable.h"
#include "shapetonFlatColonRows.h"
#include "shapetonTriangleQualityChart.h"
#include "shapetonFlatPictureSize.h"
#include "shapetonHtmlReport.h"

#include <cmath>

namespace shapeton
{
namespace
{
using Facts = ColonFlatteningReportContent::Facts;

std::string
Rounded(double value, int digits = 4)
{
  return CsvTable::Rounded(value, digits);
}

std::string
Percent(double share)
{
  return Rounded(100.0 * share, 3) + " %";
}

std::string
Point(const Eigen::Vector3d & p)
{
  return Rounded(p.x()) + ", " + Rounded(p.y()) + ", " + Rounded(p.z());
}

std::string
MetricInWords(const ColonFlattening & flattening)
{
  if (flattening.metric == FlatMetric::Euclidean)
  {
    return "straight lengths of edges";
  }
  const std::string pairs =
    flattening.metric == FlatMetric::HeatDiffusion ? "all" : "the first " + std::to_string(flattening.eigenpairs);
  return "heat diffusion distance of " + pairs + " eigenpairs, t = " + Rounded(flattening.time) + " mm^2";
}

Facts
SummaryOf(const ColonFlattening & flattening)
{
  const TubeMap &   map = flattening.map;
  const std::string handles =
    std::to_string(flattening.genusBefore) + ", in the map " + std::to_string(flattening.genusAfter);
  const std::string flips = std::to_string(flattening.distortion.flips) + ", away from handles " +
                            std::to_string(flattening.flipsAwayFromHandles);
  Facts facts{ { "Faces", std::to_string(flattening.surface.NumberOfFaces()) },
               { "Metric of the map", MetricInWords(flattening) },
               { "Mean circumference", Rounded(map.circumference) + " mm" },
               { "Length of the map", Rounded(map.length) + " mm" },
               { "Conformal moduli", Rounded(map.modulusU, 6) + " and " + Rounded(map.modulusV, 6) },
               { "Their gap (the error bar without handles)", Percent(map.Gap()) },
               { "Handles", handles },
               { "Flipped faces", flips } };
  if (flattening.cutOffAreaFraction > 0.0)
  {
    facts.emplace_back("Cut off, because its map would fold", Percent(flattening.cutOffAreaFraction) + " of the wall");
  }
  return facts;
}

std::string
CaptionOf(FlatColoring coloring)
{
  switch (coloring)
  {
    case FlatColoring::Volume:
      return "The CT along the wall normals: gas is transparent, tissue opaque, contrast medium white.";
    case FlatColoring::Relief:
      return "The wall lit from the left: folds are transverse bands with a bright and a dark side.";
    default:
      return "Mean curvature: red bulges into the lumen (folds, polyps), blue outwards.";
  }
}

void
AddPictures(HtmlReport &              html,
            const FlatColonPictures & pictures,
            bool                      hasCt,
            const std::string &       folder,
            const OutputPath &        outputPath)
{
  html.AddHeading("Flat pictures");
  html.AddParagraph(
    "The wall from the rectum to the cecum, cut open along the colon and unrolled, in rows. Rulers "
    "show the distance along the centerline. The map preserves shapes but not sizes: the bar above each row "
    "is valid for its median scale. Gray hatched parts are wall interpolated over a collapsed segment; long ones "
    "are shortened at a break.");
  std::vector<PictureFile>  files;
  std::vector<FlatColoring> colorings{ FlatColoring::Relief, FlatColoring::Curvature };
  if (hasCt)
  {
    colorings.insert(colorings.begin(), FlatColoring::Volume);
  }
  for (const FlatColoring coloring : colorings)
  {
    files.push_back({ outputPath(folder + "/flat-" + NameOf(coloring) + ".png"),
                      [&pictures, coloring] { return pictures.Draw(coloring, "", pixelsOfRow); },
                      CaptionOf(coloring) });
  }
  AddPictures(html, files);
}

void
AddScales(HtmlReport & html, const FlatColonPictures & pictures)
{
  CsvTable table({ "row", "from, cm", "to, cm", "mm of wall for 1 mm of the map", "10 %", "90 %" });
  int      number = 0;
  for (const FlatColonRow & row : BreakIntoRows(pictures.Grid(), pixelsOfRow, FlatColonPageOptions().longestBridge))
  {
    const auto centimeters = [&](int column) {
      const std::vector<double> & distances = pictures.Distances();
      const double                mm = distances.empty() ? column * pictures.Grid().PixelSize() : distances[column];
      constexpr double            millimetersPerCm = 10.0;
      constexpr int               digits = 5;
      return Rounded(std::round(mm) / millimetersPerCm, digits);
    };
    table.AddRow({ std::to_string(++number),
                   centimeters(row.firstColumn),
                   centimeters(row.firstColumn + row.columns - 1),
                   Rounded(row.scale, 3),
                   Rounded(row.lowScale, 3),
                   Rounded(row.highScale, 3) });
  }
  html.AddTable(table, "Local scale of the rows: median, and 10 and 90 % of their pixels");
}

void
AddDistortion(HtmlReport &            html,
              const ColonFlattening & flattening,
              const std::string &     folder,
              const OutputPath &      outputPath)
{
  html.AddHeading("Distortion");
  CsvTable                table({ "metric", "dilatation, median", "95 %", "99 %", "2r/R, mean", "2r/R below 0.6" });
  const std::vector<char> isCap = FacesOfCaps(flattening.surface);
  const auto              addRow =
    [&](const std::string & name, const FlatDistortion & distortion, const TriangleQuality & quality) {
      const DistortionQuantiles quantiles = QuantilesOfDilatation(distortion, isCap);
      table.AddRow({ name,
                     Rounded(quantiles.median),
                     Rounded(quantiles.p95),
                     Rounded(quantiles.p99),
                     Rounded(quality.mean, 3),
                     Percent(quality.shareBelowThreshold) });
    };
  addRow("of the map", flattening.distortion, flattening.quality);
  addRow("straight edges", flattening.distortionInSpace, flattening.qualityInSpace);
  html.AddTable(table, "Quasi-conformal dilatation (1: a circle stays a circle) and shape of the triangles");
  const std::string path = outputPath(folder + "/triangle-quality.png");
  WritePng(DrawTriangleQualities(flattening), path);
  html.AddPicture(path, "Shape of the triangles: faces by 2r/R.");
}

void
AddHandles(HtmlReport & html, const ColonFlattening & flattening)
{
  html.AddHeading("Handles");
  const auto & handles = flattening.handles.handles;
  if (handles.empty())
  {
    html.AddParagraph("No handles were found.");
    return;
  }
  CsvTable table({ "number", "genus", "place, LPS mm", "u, v on the map, mm", "radius, mm" });
  for (std::size_t i = 0; i < handles.size(); ++i)
  {
    const SurfaceHandle & handle = handles[i];
    table.AddRow({ std::to_string(i + 1),
                   std::to_string(handle.genus),
                   Point(handle.place),
                   Rounded(handle.flatPlace.x()) + ", " + Rounded(handle.flatPlace.y()),
                   Rounded(handle.radius, 3) });
  }
  const std::string before =
    flattening.genusAfter < flattening.genusBefore ? "; u, v on the map before they were removed" : "";
  html.AddTable(table, "Handles by the Gauss-Bonnet theorem, marked in the pictures" + before);
}

void
AddCaps(HtmlReport & html, const ColonFlattening & flattening)
{
  if (flattening.caps.empty())
  {
    return;
  }
  html.AddHeading("Blind pouches");
  html.AddParagraph("The flat map of these pouches would fold and hide them. They were cut off and "
                    "closed by caps (cell array cap).");
  CsvTable table({ "cap", "place, LPS mm", "neck, mm", "area cut off, mm^2" });
  for (std::size_t i = 0; i < flattening.caps.size(); ++i)
  {
    const PouchCap & cap = flattening.caps[i];
    table.AddRow({ std::to_string(i + 1), Point(cap.place), Rounded(cap.neck, 3), Rounded(cap.area, 3) });
  }
  html.AddTable(table, "Caps; the neck is the length of the rim");
}
} // namespace

std::vector<FlatAnnotation>
AnnotationsOfHandles(const ColonFlattening & flattening)
{
  std::vector<FlatAnnotation> annotations;
  for (const SurfaceHandle & handle : flattening.handles.handles)
  {
    annotations.push_back({ FlatAnnotation::Kind::Mark, std::to_string(annotations.size() + 1), {}, handle.place });
  }
  return annotations;
}

void
WriteColonFlatteningReport(const ColonFlatteningReportContent & content,
                           const std::string &                  folder,
                           const OutputPath &                   outputPath)
{
  const ColonFlattening & flattening = *content.flattening;
  const FlatColonPictures pictures(content.parts, flattening.map.circumference / pixelsAround);
  HtmlReport              html("Flat colon");
  html.AddHead(SummaryOf(flattening), content.warnings);
  AddPictures(html, pictures, content.parts.ct != nullptr, folder, outputPath);
  AddScales(html, pictures);
  AddDistortion(html, flattening, folder, outputPath);
  AddHandles(html, flattening);
  AddCaps(html, flattening);
  html.AddHeading("Provenance");
  html.AddFacts(content.provenance);
  html.Write(outputPath(folder + "/index.html"));
}
} // namespace shapeton
