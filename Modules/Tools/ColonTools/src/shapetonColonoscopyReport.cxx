#include "shapetonColonoscopyReport.h"

#include "shapetonColonFigures.h"
#include "shapetonColonoscopyFacts.h"
#include "shapetonColonoscopyLimitations.h"
#include "shapetonColonoscopyPictures.h"
#include "shapetonDistensionChart.h"
#include "shapetonHtmlReport.h"
#include "shapetonPolypCandidateReport.h"
#include "shapetonRegistrationReport.h"

#include <filesystem>

namespace shapeton
{
namespace
{
constexpr const char * viewerPage = "viewer/viewer.html";

/** Embeds pictures into the page only. They are written to a temporary folder, which is removed; leftovers of a killed
 * run are removed by the next one. */
class PagePictures
{
public:
  PagePictures(HtmlReport & html, const std::string & folder) : m_Html(html), m_Folder(folder)
  {
    std::filesystem::create_directories(m_Folder);
  }

  ~PagePictures()
  {
    std::error_code error;
    std::filesystem::remove_all(m_Folder, error);
  }

  void
  Add(const Picture * picture, const std::string & caption)
  {
    const std::string path = (m_Folder / "picture.png").string();
    WritePng(picture, path);
    m_Html.AddPicture(path, caption);
  }

  /** Draws several pictures in parallel; their names do not matter. */
  void
  Add(std::vector<PictureFile> pictures)
  {
    for (std::size_t i = 0; i < pictures.size(); ++i)
    {
      pictures[i].path = (m_Folder / (std::to_string(i) + ".png")).string();
    }
    AddPictures(m_Html, pictures);
  }

private:
  HtmlReport &          m_Html;
  std::filesystem::path m_Folder;
};

std::vector<HtmlReport::LinkedItem>
LinkedLimitations(const std::vector<Limitation> & limitations, bool hasViewer)
{
  std::vector<HtmlReport::LinkedItem> items;
  for (const Limitation & one : limitations)
  {
    HtmlReport::LinkedItem item{ one.text, "", "Show in the viewer" };
    if (hasViewer && one.place)
    {
      item.path = viewerPage + AnchorOfPlace(*one.place);
    }
    items.push_back(item);
  }
  return items;
}

void
AddDistension(HtmlReport & html, PagePictures & pictures, const ColonoscopyResults & results)
{
  html.AddHeading("Distension");
  pictures.Add(DrawDistensionChart(results.centerline, ChartSegmentsOf(results)),
               "Caliber (diameter of the maximum inscribed sphere) along the centerline. The dashed line marks 10 mm.");
}

void
AddViews(HtmlReport & html, PagePictures & pictures, const ColonoscopyResults & results)
{
  html.AddHeading("Views in space");
  const bool        hasLandmarks = results.labeled.F.rows() > 0;
  const std::string what =
    hasLandmarks ? "The wall colored by segments; taeniae 1 yellow, 2 blue, 3 pink; flexures dark." : "The wall.";
  std::vector<PictureFile> drawings{
    { "", [&] { return DrawSegments(results, PatientSide::Anterior); }, what },
    { "", [&] { return DrawSegments(results, PatientSide::Posterior); }, "The same view from the back." }
  };
  if (!results.centerline.curves.empty())
  {
    drawings.push_back({ "",
                         [&] { return DrawInside(results, PatientSide::Anterior); },
                         "The transparent wall with the centerline colored by the distance from the anal verge" +
                           std::string(results.flexures.curves.empty() ? "." : ", and the flexures.") });
    drawings.push_back(
      { "", [&] { return DrawInside(results, PatientSide::Left); }, "The same view from the patient's left side." });
  }
  pictures.Add(drawings);
}

void
AddFlat(HtmlReport & html, PagePictures & pictures, const ColonoscopyResults & results)
{
  html.AddHeading("Virtual dissection (unfolded view)");
  html.AddParagraph(
    "The wall from the rectum to the cecum, cut open along the colon and unrolled, in rows, as seen from "
    "the lumen. Rulers show the distance along the centerline. The map preserves shapes but not sizes: the bar "
    "above each row is valid for its median scale. Gray hatched parts are wall interpolated over a "
    "collapsed segment; parts hatched in the other direction, over the picture, are not evaluable.");
  std::string marks;
  marks += results.taeniae.curves.empty() ? "" : " Taeniae: 1 yellow, 2 blue, 3 pink.";
  marks += results.foldLabels ? " Green outlines: haustral folds." : "";
  marks += results.original ? " Yellow outlines: wall coated by tagged residue. Blue outlines: seams of electronic "
                              "cleansing at fluid levels, not evaluable."
                            : "";
  const std::vector<unsigned short> covers = CoverPixels(results);
  std::vector<PictureFile>          drawings;
  if (results.ct)
  {
    drawings.push_back({ "",
                         [&] { return DrawFlat(results, covers, FlatColoring::Volume); },
                         "The wall, rendered from the CT along its normals." + marks });
  }
  drawings.push_back({ "",
                       [&] { return DrawFlat(results, covers, FlatColoring::Curvature); },
                       "Mean curvature: red bulges into the lumen (folds, polyps), blue outwards." + marks });
  pictures.Add(drawings);
}

/** Adds the identification of the examination that is printed on each page: the series or the beginning of the input's
 * hash, and the version. */
void
AddIdentity(HtmlReport & html, const ColonoscopyReportContent::Facts & provenance)
{
  constexpr std::size_t enough = 23; // characters: "sha256:" and 16 digits
  std::string           series, version;
  for (const auto & [name, value] : provenance)
  {
    series = name == "input.inputVolume" ? value : series;
    version = name == "version" ? value : version;
  }
  series = series.rfind("sha256:", 0) == 0 ? series.substr(0, enough) : series;
  html.AddMarkup("<div class=\"identity\">");
  html.AddParagraph((series.empty() ? "" : series + ", ") + "Shapeton " + version);
  html.AddMarkup("</div>\n");
}

PolypsOfPage
PolypsOf(const ColonoscopyResults & results)
{
  return { results.polyps, results.polypsOfOther, results.isSecond };
}

/** The first page: what a reader needs before the pictures. */
void
AddFirstPage(HtmlReport & html, const ColonoscopyReportContent & content)
{
  const ColonoscopyResults & results = *content.results;
  const ColonoscopyQuality & quality = content.quality;
  html.BeginPage();
  AddIdentity(html, content.provenance);
  html.AddResearchNote();
  if (!content.failure.empty())
  {
    html.AddNote(content.failure);
  }
  html.AddFacts(SummaryOf(content));
  if (const std::string note = NoteOfInadequate(results, quality); !note.empty())
  {
    html.AddNote(note);
  }
  if (!quality.segments.empty())
  {
    html.AddHeading("Quality by segment");
    html.AddTable(
      QualityTable(quality).WithoutEmptyColumns(),
      "Distances from the anal verge. Caliber of the maximum inscribed sphere, without the anal canal. Evaluable "
      "wall: visible part of the length, or part shown on the flat map if that is smaller" +
        std::string(quality.isOfMask ? "" : ", without seams of cleansing (within 2.5 mm of fluid levels)"));
  }
  if (results.IsDone(colonoscopystage::polyps))
  {
    const PolypsOfPage polyps = PolypsOf(results);
    AddPolypCandidateTable(html, results.centerline, polyps);
    AddPolypsOfOtherPosition(html, polyps);
  }
  if (const std::vector<Limitation> limitations = LimitationsOf(results, quality);
      !limitations.empty() && !results.quality.is_null())
  {
    html.AddHeading("Limitations of this examination");
    if (results.lumen)
    {
      html.AddParagraph(SliceOrderInWords(results.lumen));
    }
    html.AddNumberedList(LinkedLimitations(limitations, results.IsDone(colonoscopystage::viewer)));
  }
  html.EndPage();
}

void
AddPolyps(HtmlReport & html, const ColonoscopyResults & results)
{
  PolypCards cards{ PolypsOf(results),
                    results.lumen,
                    results.IsDone(colonoscopystage::viewer) ? viewerPage : "",
                    (results.isSecond ? std::string("..") : secondPositionFolder) + "/report.html" };
  cards.pictureOf = [&](int number) {
    const auto i = static_cast<std::size_t>(number);
    return i < results.polypPictures.size() ? results.polypPictures[i] : std::string();
  };
  AddPolypCandidateCards(html, cards);
}

void
AddPair(HtmlReport & html, PagePictures & pictures, const ColonoscopyPair & pair)
{
  const RegistrationParts parts{ &pair.first, &pair.second, &pair.registration };
  html.AddHeading("Two positions");
  html.AddParagraph("The first series is called supine, the second prone. "
                    "The separate report of the second series is " +
                    std::string(secondPositionFolder) + "/report.html.");
  html.AddFacts(RegistrationFacts(parts));
  AddRegistrationSection(html, parts, [&](const Picture * picture, const std::string &, const std::string & caption) {
    pictures.Add(picture, caption);
  });
}

void
AddLandmarks(HtmlReport & html, const ColonoscopyResults & results)
{
  html.AddHeading("Landmarks");
  if (!results.IsDone(colonoscopystage::landmarks))
  {
    html.AddParagraph("None: the stage was not run.");
    return;
  }
  html.AddTable(FlexureTable(results).WithoutEmptyColumns(), "Flexures; confidence from 0 to 1");
  const Json valve = results.quality.value("/ileocecalValve/position"_json_pointer, Json());
  if (results.IsDone(colonoscopystage::viewer) && valve.is_array())
  {
    const auto place = valve.get<std::array<double, 3>>();
    html.AddLink(viewerPage + AnchorOfPlace({ place[0], place[1], place[2] }),
                 "Show the ileocecal valve in the viewer");
  }
}

void
AddTechnicalDetails(HtmlReport & html, const ColonoscopyReportContent & content)
{
  html.BeginDetails("Technical details: messages of the stages, methods, files and provenance");
  html.AddSubheading("Messages");
  html.AddWarnings(content.warnings);
  if (content.warnings.empty())
  {
    html.AddParagraph("None.");
  }
  html.AddSubheading("Methods");
  html.AddFacts(MethodFactsOf(content));
  if (content.results->IsDone(colonoscopystage::landmarks))
  {
    html.AddTable(TaeniaTable(*content.results), "Taeniae; confidence from 0 to 1");
  }
  html.AddSubheading("Stages");
  html.AddTable(StageTable(content), "The files are in the folder of the stage, their SHA-256 in stages/STAGE.json");
  html.AddSubheading("Provenance");
  html.AddFacts(content.provenance);
  html.EndDetails();
}
} // namespace

void
WriteColonoscopyReport(const ColonoscopyReportContent & content,
                       const std::string &              path,
                       const std::string &              scratchFolder)
{
  const ColonoscopyResults & results = *content.results;
  HtmlReport                 html("Virtual colonoscopy");
  PagePictures               pictures(html, scratchFolder);
  if (results.IsDone(colonoscopystage::viewer))
  {
    html.AddLink(viewerPage,
                 "Read this examination: virtual dissection, wall in space, endoluminal view and slices with a linked "
                 "crosshair");
  }
  if (results.isSecond)
  {
    html.AddLink("../report.html", "Report of the first position, with the viewer of both");
  }
  AddFirstPage(html, content);
  if (results.IsDone(colonoscopystage::polyps))
  {
    AddPolyps(html, results);
  }
  if (!results.centerline.curves.empty())
  {
    AddDistension(html, pictures, results);
  }
  AddLandmarks(html, results);
  if (results.flat)
  {
    AddFlat(html, pictures, results);
  }
  if (results.wall.F.rows() > 0)
  {
    AddViews(html, pictures, results);
  }
  if (results.pair)
  {
    AddPair(html, pictures, *results.pair);
  }
  AddTechnicalDetails(html, content);
  html.Write(path);
}
} // namespace shapeton
