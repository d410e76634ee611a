#include "shapetonGraphReport.h"
#include "shapetonGraphPageData.h"
#include "shapetonHtmlReport.h"
#include "shapetonPageBlocks.h"
#include "shapetonSvgPanel.h"

#include <algorithm>

namespace shapeton
{
extern const char * const GraphScript[];
extern const char * const GraphStyle[];

namespace
{
std::string
Switch(const char * name, const char * label, bool isOn)
{
  return std::string("<label><input type=\"checkbox\" name=\"") + name + '"' + (isOn ? " checked=\"checked\"" : "") +
         "/> " + label + "</label>\n";
}

/** Graphs of one geometry, moved together. */
using ViewGroup = std::vector<const GraphView *>;

std::string
Switches(const ViewGroup & views, DiskModel disk)
{
  const EmbeddingGeometry geometry = views.front()->certificate->geometry;
  const bool              hasLabels =
    std::any_of(views.begin(), views.end(), [](const GraphView * view) { return view->hasLabels; });
  const bool  isSphere = geometry == EmbeddingGeometry::Spherical;
  std::string text = "<div class=\"switches\">\n" + Switch("graph", "graph", true) + Switch("dual", "dual", false) +
                     Switch("nodes", "nodes", true) + Switch("nodeCircles", "circles of nodes", true) +
                     Switch("faceCircles", "circles of faces", false) + Switch("labels", "labels", hasLabels);
  if (isSphere)
  {
    text += "<select><option value=\"ball\">sphere</option><option value=\"flat\">stereographic</option></select>\n";
  }
  else
  {
    text += Switch("tiles", "domains", true);
  }
  if (geometry == EmbeddingGeometry::Hyperbolic)
  {
    const std::string klein = disk == DiskModel::Klein ? " selected=\"selected\"" : "";
    text += "<select><option value=\"poincare\">Poincare disk</option><option value=\"klein\"" + klein +
            ">Klein disk</option></select>\n";
  }
  return text + "<button type=\"button\">reset</button>\n</div>\n";
}

std::string
HelpOf(EmbeddingGeometry geometry)
{
  switch (geometry)
  {
    case EmbeddingGeometry::Spherical:
      return "Drag to turn the sphere, Shift and drag to move by a Moebius transformation, wheel to zoom "
             "at the pointer by another one: circles stay circles, and edges do not cross.";
    case EmbeddingGeometry::Euclidean:
      return "Drag to move, Shift and drag to turn, wheel to zoom. The domains are copies of one torus.";
    default:
      return "Drag to move by an isometry of the hyperbolic plane (a Moebius transformation of the disk), Shift and "
             "drag to turn, wheel to enlarge. The domains are copies of one surface.";
  }
}

std::string
LegendOf(const GraphView & view)
{
  return view.colorBar ? "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"290\" height=\"46\">\n" +
                           ColorBarMarkup(*view.colorBar, 0, 0) + "</svg>"
                       : std::string();
}

void
AddGroup(const ViewGroup & views, DiskModel disk, int & number, HtmlReport & page)
{
  page.AddMarkup("<div class=\"graph-group\">\n" + Switches(views, disk) + "<div class=\"graphs\">\n");
  for (const GraphView * view : views)
  {
    const std::string id = "graph" + std::to_string(number++);
    page.AddMarkup("<figure data-graph=\"" + id + "\"><div class=\"stack\"></div><figcaption>" + SvgText(view->title) +
                   "</figcaption>\n<script type=\"application/json\" id=\"" + id + "\">" +
                   ScriptText(PageDataOf(*view)) + "</script>" + LegendOf(*view) + "</figure>\n");
  }
  page.AddMarkup("</div>\n</div>\n");
  page.AddParagraph(HelpOf(views.front()->certificate->geometry));
}

/** Views by geometry; views that are too large are replaced by a note on the page. */
std::vector<ViewGroup>
GroupsOf(const std::vector<GraphView> & views, HtmlReport & page)
{
  constexpr std::size_t  mostEdges = 200000; // a page of 60 MB
  std::vector<ViewGroup> groups(3);
  for (const GraphView & view : views)
  {
    const std::size_t edges = view.certificate->packed.edges.size();
    if (edges > mostEdges)
    {
      page.AddNote(view.title + ": the map has " + std::to_string(edges) + " edges, too many for a page.");
      continue;
    }
    const EmbeddingGeometry geometry = view.certificate->geometry;
    groups[geometry == EmbeddingGeometry::Spherical   ? 0
           : geometry == EmbeddingGeometry::Euclidean ? 1
                                                      : 2]
      .push_back(&view);
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(), [](const ViewGroup & group) { return group.empty(); }),
               groups.end());
  return groups;
}

void
AddViews(const GraphReport & report, HtmlReport & page)
{
  const std::vector<ViewGroup> groups = GroupsOf(report.views, page);
  if (groups.empty())
  {
    return;
  }
  page.AddStyle(PageText(GraphStyle));
  page.AddMarkup("<noscript><p>The view requires JavaScript, which is included in this page.</p></noscript>\n"
                 "<div id=\"tools\"></div>\n");
  const Json tracking{ { "colors", TrackColors() }, { "nodes", report.tracked }, { "isSequence", report.isSequence } };
  page.AddMarkup("<script type=\"application/json\" id=\"tracking\">" + ScriptText(tracking) + "</script>\n");
  int number = 0;
  for (const ViewGroup & group : groups)
  {
    AddGroup(group, report.disk, number, page);
  }
  page.AddMarkup("<script>//<![CDATA[\n" + PageText(GraphScript) + "//]]></script>\n");
}
} // namespace

void
WriteGraphReport(const GraphReport & report, const std::string & path)
{
  HtmlReport page(report.title);
  AddViews(report, page);
  page.AddWarnings(report.warnings);
  for (const std::string & paragraph : report.paragraphs)
  {
    page.AddParagraph(paragraph);
  }
  for (const auto & [caption, table] : report.tables)
  {
    page.AddTable(table, caption);
  }
  if (!report.facts.empty())
  {
    page.AddHeading("Facts");
    page.AddFacts(report.facts);
  }
  page.Write(path);
}

std::vector<std::pair<std::string, std::string>>
FactsOf(const EmbeddingCertificate & certificate)
{
  std::vector<std::pair<std::string, std::string>> facts{
    { "nodes", std::to_string(certificate.graph.nodes) },
    { "edges", std::to_string(certificate.graph.edges.size()) },
    { "dummy nodes", std::to_string(certificate.packed.nodes - certificate.graph.nodes) },
    { "genus", std::to_string(certificate.genus) },
    { "geometry", NameOf(certificate.geometry) }
  };
  for (const auto & [name, value] : certificate.statistics)
  {
    facts.emplace_back(name, CsvTable::Rounded(value, 4));
  }
  facts.insert(facts.end(), certificate.provenance.begin(), certificate.provenance.end());
  return facts;
}
} // namespace shapeton
