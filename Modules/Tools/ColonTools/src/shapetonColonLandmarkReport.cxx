#include "shapetonColonLandmarkReport.h"

#include "shapetonColonFigures.h"
#include "shapetonCommandLine.h"
#include "shapetonHtmlReport.h"
#include "shapetonPlaceInWords.h"

#include <cmath>

namespace shapeton
{
namespace
{
std::string
RemarkOn(const SegmentBorder & border, const ColonLandmarks & landmarks)
{
  const std::string hindrance = landmarks.hindered ? InWords(HindranceAt(*landmarks.hindered, border.arcLength)) : "";
  return !hindrance.empty() ? "not evaluable: " + hindrance : border.confidence < 0.5 ? "uncertain: check it" : "";
}

CsvTable
FlexureTable(const ColonLandmarks & landmarks)
{
  CsvTable table({ "Flexure", "From the anal verge (cm)", "Position (LPS, mm)", "Confidence", "Remark" });
  for (const ColonFlexure & flexure : landmarks.flexures.flexures)
  {
    const SegmentBorder * border = nullptr;
    for (const SegmentBorder & one : landmarks.segments.borders)
    {
      border = one.number == flexure.number ? &one : border;
    }
    if (border == nullptr)
    {
      table.AddRow({ NameOfFlexure(flexure.number), "", "", "", "not found: " + flexure.reason });
      continue;
    }
    const Eigen::Vector3d & p = border->point;
    table.AddRow({ NameOfFlexure(flexure.number),
                   NumberOfCentimeters(border->arcLength),
                   WholeNumber(p.x()) + ", " + WholeNumber(p.y()) + ", " + WholeNumber(p.z()),
                   ProbabilityInWords(border->confidence),
                   RemarkOn(*border, landmarks) });
  }
  return table;
}

std::string
ValveInWords(const ColonLandmarks & landmarks)
{
  const std::string cecum = landmarks.segments.isCecumAtValve
                              ? "The cecum ends at the valve."
                              : "The end of the cecum is estimated: 6 cm before the end of the centerline.";
  if (!landmarks.valve)
  {
    return "Ileocecal valve: not found. " + cecum;
  }
  return "Ileocecal valve: at " + PlaceInWords(landmarks.valve->position) + ", " +
         Centimeters(landmarks.valve->arcLength) + " from the anal verge, confidence " +
         ProbabilityInWords(landmarks.valve->confidence) + ". " + cecum;
}

CsvTable
TaeniaTable(const ColonTaeniae & taeniae, const TaeniaNames & names)
{
  CsvTable table({ "Taenia", "Name", "Length on the wall (cm)", "Mean confidence", "Markers" });
  for (std::size_t t = 0; t < taeniae.taeniae.size(); ++t)
  {
    const ColonTaenia & taenia = taeniae.taeniae[t];
    double              length = 0.0;
    double              confidence = 0.0;
    for (std::size_t i = 0; i < taenia.points.size(); ++i)
    {
      length += i > 0 ? (taenia.points[i] - taenia.points[i - 1]).norm() : 0.0;
      confidence += taenia.confidence[i] / static_cast<double>(taenia.points.size());
    }
    int markers = 0;
    for (const UsedMarker & marker : taeniae.markers)
    {
      markers += marker.taenia == static_cast<int>(t) + 1 ? 1 : 0;
    }
    table.AddRow({ std::to_string(t + 1),
                   NameOf(names.names[t]),
                   NumberOfCentimeters(length),
                   ProbabilityInWords(confidence),
                   std::to_string(markers) });
  }
  return table;
}

CsvTable
PieceTable(const ColonPieces & pieces)
{
  CsvTable table({ "Segment", "Modulus (height over width)", "Width (mm)", "Height (mm)", "Area (mm^2)" });
  for (const ColonPiece & piece : pieces.pieces)
  {
    table.AddRow({ piece.name,
                   CsvTable::Rounded(std::sqrt(piece.modulusU * piece.modulusV), 4),
                   WholeNumber(piece.width),
                   WholeNumber(piece.height),
                   WholeNumber(piece.area) });
  }
  return table;
}

std::string
HowTaeniaeWereNamed(const TaeniaNames & names)
{
  return names.AreKnown() ? " The names follow from the directions of the taeniae in descending, transverse and "
                            "ascending colon."
                          : " The taeniae have no names: " + names.reason + ".";
}

std::string
HowTaeniaeWereFound(const ColonTaeniae & taeniae, const TaeniaNames & names)
{
  if (!taeniae.reason.empty())
  {
    return "No taeniae: " + taeniae.reason + ".";
  }
  return "Rule " + NameOf(taeniae.rule) + ", kept: " + taeniae.kept + ". Energy of the joint optimization " +
         CsvTable::Rounded(taeniae.jointEnergy, 4) + ", of fuzzy C-means " + CsvTable::Rounded(taeniae.fuzzyEnergy, 4) +
         " (lower is better). They are " + CsvTable::Rounded(taeniae.meanDisagreement, 3) +
         " mm apart on average, more than 10 mm along " + WholePercent(taeniae.disagreeingShare) + " of the colon." +
         HowTaeniaeWereNamed(names);
}
} // namespace

void
WriteColonLandmarkReport(CommandLine &          commandLine,
                         const std::string &    folder,
                         const FlatColon &      flat,
                         const ColonLandmarks & landmarks,
                         const ColonPieces *    pieces)
{
  if (folder.empty())
  {
    return;
  }
  HtmlReport report("Landmarks of a colon");
  report.AddParagraph("For research use; not a diagnosis.");
  report.AddWarnings(commandLine.GetWarnings());
  const auto                     path = [&](const char * name) { return commandLine.Output(folder + '/' + name); };
  const ColonLandmarkParts       parts{ &flat, &landmarks };
  const std::vector<PictureFile> pictures{
    { path("landmarks-anterior.png"), [&] { return DrawColonLandmarks(parts, PatientSide::Anterior); } },
    { path("landmarks-posterior.png"), [&] { return DrawColonLandmarks(parts, PatientSide::Posterior); } },
    { path("landmarks-flat.png"), [&] { return DrawFlatLandmarks(parts); } },
    { path("folds-surface.png"), [&] { return DrawSurfaceFolds(parts, PatientSide::Anterior); } }
  };
  WritePngs(pictures);
  report.AddHeading("Segments, taeniae and flexures");
  report.AddPicture(pictures[0].path, "From the front");
  report.AddPicture(pictures[1].path, "From the back");
  report.AddTable(FlexureTable(landmarks), "Flexures");
  report.AddParagraph(ValveInWords(landmarks));
  report.AddHeading("Flat colon");
  report.AddPicture(pictures[2].path, "Taeniae and flexures on the flat colon; hatched parts are not evaluable");
  report.AddParagraph(HowTaeniaeWereFound(landmarks.taeniae, landmarks.taeniaNames));
  report.AddTable(TaeniaTable(landmarks.taeniae, landmarks.taeniaNames), "Taeniae");
  report.AddHeading("Folds on the surface");
  report.AddPicture(pictures[3].path, "Folds found without the flat map");
  if (pieces != nullptr)
  {
    report.AddHeading("Split colon");
    report.AddTable(PieceTable(*pieces), "Conformal moduli of the segments, each cut along a taenia");
  }
  report.AddHeading("Provenance");
  report.AddFacts(commandLine.GetProvenance());
  report.Write(commandLine.Output(folder + "/index.html"));
}
} // namespace shapeton
