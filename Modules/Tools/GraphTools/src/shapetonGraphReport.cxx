#include "shapetonGraphReport.h"
#include "shapetonGraphTiles.h"
#include "shapetonGraphViewerScript.h"
#include "shapetonHtmlReport.h"
#include "shapetonSvgPanel.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace shapeton
{
namespace
{
/** Lists of numbers and texts as JSON that may stand in a page: no character of it is markup. */
class JsonText
{
public:
  void
  Key(const char * key)
  {
    m_Text += m_Text.empty() ? "{\"" : ",\"";
    m_Text += key;
    m_Text += "\":";
  }

  void
  Numbers(const char * key, const std::vector<double> & values)
  {
    this->Key(key);
    m_Text += '[';
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      m_Text += i > 0 ? "," : "";
      this->Append(values[i]);
    }
    m_Text += ']';
  }

  void
  Number(const char * key, double value)
  {
    this->Key(key);
    this->Append(value);
  }

  void
  Texts(const char * key, const std::vector<std::string> & values)
  {
    this->Key(key);
    m_Text += '[';
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      m_Text += i > 0 ? "," : "";
      this->Append(values[i]);
    }
    m_Text += ']';
  }

  void
  Text(const char * key, const std::string & value)
  {
    this->Key(key);
    this->Append(value);
  }

  std::string
  Take()
  {
    return m_Text + '}';
  }

private:
  void
  Append(double value)
  {
    constexpr int digits = 9; // more than a screen shows
    char          text[40];
    const auto    end = std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits).ptr;
    m_Text.append(text, end);
  }

  void
  Append(const std::string & value)
  {
    m_Text += '"';
    for (const char c : value)
    {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x20 || c == '"' || c == '\\' || c == '<' || c == '>' || c == '&')
      {
        static const char digits[] = "0123456789abcdef";
        m_Text += std::string("\\u00") + digits[byte / 16] + digits[byte % 16];
      }
      else
      {
        m_Text += c;
      }
    }
    m_Text += '"';
  }

  std::string m_Text;
};

class ViewData
{
public:
  explicit ViewData(const GraphView & view) : m_View(view), m_Graph(*view.certificate) {}

  std::string
  Text() const
  {
    const EmbeddingCertificate & certificate = *m_View.certificate;
    JsonText                     json;
    json.Text("geometry", NameOf(certificate.geometry));
    json.Text("title", m_View.title);
    std::vector<std::string> names;
    std::vector<double>      nodes;
    for (int node = 0; node < certificate.graph.nodes; ++node)
    {
      names.push_back(NameOfNode(certificate.graph, node));
      this->Append(nodes, m_Graph.nodes[node]);
      nodes.push_back(certificate.nodeRadii[node]);
    }
    json.Texts("names", names);
    json.Numbers("nodes", nodes);
    if (!m_View.nodeColors.empty())
    {
      json.Texts("colors", m_View.nodeColors);
    }
    std::vector<double> faces;
    for (std::size_t face = 0; face < m_Graph.faces.size(); ++face)
    {
      if (m_Graph.isVisibleFace[face] != 0)
      {
        this->Append(faces, m_Graph.faces[face]);
        faces.push_back(certificate.faceRadii[face]);
      }
    }
    json.Numbers("faces", faces);
    json.Numbers("edges", this->Segments(m_Graph.halfEdges));
    json.Numbers("dual", this->Segments(m_Graph.dual));
    this->AddCover(json);
    return json.Take();
  }

private:
  void
  Append(std::vector<double> & numbers, const Place & place) const
  {
    numbers.insert(numbers.end(), { place.x, place.y });
    if (m_Graph.space.Geometry() == EmbeddingGeometry::Spherical)
    {
      numbers.push_back(place.z);
    }
  }

  std::vector<double>
  Segments(const std::vector<EmbeddedGraph::Segment> & segments) const
  {
    std::vector<double> numbers;
    for (const auto & segment : segments)
    {
      this->Append(numbers, segment[0]);
      this->Append(numbers, segment[1]);
    }
    return numbers;
  }

  /** Tiles, the boundary of the domain, and where a picture of the plane has its middle. */
  void
  AddCover(JsonText & json) const
  {
    constexpr double    mostSegments = 60000.0; // that a canvas paints while the mouse is dragged
    const double        segments = static_cast<double>(m_Graph.halfEdges.size() + 1);
    const double        least = 4.0 * m_View.certificate->genus + 1.0;
    const int           count = static_cast<int>(std::clamp(mostSegments / segments, least, std::max(least, 120.0)));
    std::vector<double> tiles;
    for (const Motion & tile : TilesAround(m_Graph, count))
    {
      tiles.insert(tiles.end(), { tile.a.real(), tile.a.imag(), tile.b.real(), tile.b.imag() });
    }
    json.Numbers("tiles", tiles);
    const std::vector<Place> boundary = DomainBoundary(m_Graph);
    std::vector<double>      domain;
    double                   extent = 1.0;
    Place                    middle;
    for (const Place & place : boundary)
    {
      this->Append(domain, place);
      middle = { middle.x + place.x / static_cast<double>(boundary.size()),
                 middle.y + place.y / static_cast<double>(boundary.size()),
                 0.0 };
    }
    if (m_Graph.space.Geometry() == EmbeddingGeometry::Euclidean)
    {
      extent = 0.0;
      for (const Place & place : boundary)
      {
        extent = std::max(extent, 1.2 * std::hypot(place.x - middle.x, place.y - middle.y));
      }
    }
    json.Numbers("domain", domain);
    json.Number("extent", extent);
    json.Numbers("middle", { middle.x, middle.y });
  }

  const GraphView & m_View;
  EmbeddedGraph     m_Graph;
};

std::string
Switch(const char * name, const char * label, bool isOn)
{
  return std::string("<label><input type=\"checkbox\" name=\"") + name + '"' + (isOn ? " checked=\"checked\"" : "") +
         "/> " + label + "</label>\n";
}

/** Graphs of one geometry, which are moved together. */
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
      return "Drag to turn the sphere, shift and drag to move by a Moebius transformation, wheel to zoom about the "
             "pointer by "
             "one: circles stay circles, and no edges cross.";
    case EmbeddingGeometry::Euclidean:
      return "Drag to move, shift and drag to turn, wheel to zoom. The domains are copies of one torus.";
    default:
      return "Drag to move by an isometry of the hyperbolic plane (a Moebius transformation of the disk), shift and "
             "drag to turn, wheel to "
             "enlarge. The domains are copies of one surface.";
  }
}

void
AddGroup(const ViewGroup & views, DiskModel disk, int & number, HtmlReport & page)
{
  page.AddMarkup("<div class=\"graph-group\">\n" + Switches(views, disk) + "<div class=\"graphs\">\n");
  for (const GraphView * view : views)
  {
    const std::string id = "graph" + std::to_string(number++);
    page.AddMarkup("<figure><canvas data-graph=\"" + id + "\"></canvas><figcaption>" + SvgText(view->title) +
                   "</figcaption>\n<script type=\"application/json\" id=\"" + id + "\">" + ViewData(*view).Text() +
                   "</script></figure>\n");
  }
  page.AddMarkup("</div>\n</div>\n");
  page.AddParagraph(HelpOf(views.front()->certificate->geometry));
}

void
AddViews(const GraphReport & report, HtmlReport & page)
{
  page.AddMarkup(std::string("<style>") + GraphViewerStyle() +
                 "</style>\n<noscript><p>The view needs JavaScript, which this page brings along.</p></noscript>\n");
  constexpr std::size_t mostEdges = 200000; // a page of 100 MB
  int                   number = 0;
  for (const auto geometry :
       { EmbeddingGeometry::Spherical, EmbeddingGeometry::Euclidean, EmbeddingGeometry::Hyperbolic })
  {
    ViewGroup group;
    for (const GraphView & view : report.views)
    {
      const std::size_t edges = view.certificate->packed.edges.size();
      if (view.certificate->geometry != geometry)
      {
        continue;
      }
      if (edges > mostEdges)
      {
        page.AddNote(view.title + ": the map has " + std::to_string(edges) +
                     " edges, too many for the view of a page.");
        continue;
      }
      group.push_back(&view);
    }
    if (!group.empty())
    {
      AddGroup(group, report.disk, number, page);
    }
  }
}
} // namespace

void
WriteGraphReport(const GraphReport & report, const std::string & path)
{
  HtmlReport page(report.title);
  if (!report.views.empty())
  {
    AddViews(report, page);
  }
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
  if (!report.views.empty())
  {
    page.AddMarkup(std::string("<script>//<![CDATA[") + GraphViewerScript() + "//]]></script>\n");
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
