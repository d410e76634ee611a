#include "shapetonGraphPageData.h"

#include "shapetonEmbeddedGraph.h"
#include "shapetonGraphTiles.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace shapeton
{
namespace
{
/** Rounds to 9 digits: better than screen resolution, half the bytes. */
double
Rounded(double value)
{
  constexpr int digits = 9;
  char          text[40];
  const auto    end = std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits).ptr;
  std::from_chars(text, end, value);
  return value;
}

class PageData
{
public:
  explicit PageData(const GraphView & view) : m_View(view), m_Graph(*view.certificate) {}

  Json
  Take()
  {
    m_Data["geometry"] = NameOf(m_View.certificate->geometry);
    m_Data["title"] = m_View.title;
    this->AddNodes();
    this->AddEdges();
    this->AddFaces();
    this->AddCover();
    return std::move(m_Data);
  }

private:
  bool
  IsSphere() const
  {
    return m_Graph.space.Geometry() == EmbeddingGeometry::Spherical;
  }

  void
  Append(Json & numbers, const Place & place) const
  {
    numbers.push_back(Rounded(place.x));
    numbers.push_back(Rounded(place.y));
    if (this->IsSphere())
    {
      numbers.push_back(Rounded(place.z));
    }
  }

  Json
  PlacesOf(const std::vector<Place> & places) const
  {
    Json numbers = Json::array();
    for (const Place & place : places)
    {
      this->Append(numbers, place);
    }
    return numbers;
  }

  void
  AddNodes()
  {
    const EmbeddingCertificate & certificate = *m_View.certificate;
    Json                         names = Json::array();
    Json                         radii = Json::array();
    for (int node = 0; node < certificate.graph.nodes; ++node)
    {
      names.push_back(NameOfNode(certificate.graph, node));
      radii.push_back(Rounded(certificate.nodeRadii[node]));
    }
    m_Data["names"] = std::move(names);
    m_Data["radii"] = std::move(radii);
    m_Data["places"] = this->PlacesOf(m_Graph.nodes);
    if (!m_View.nodeColors.empty())
    {
      m_Data["colors"] = m_View.nodeColors;
    }
    if (!m_View.nodeKeys.empty())
    {
      m_Data["keys"] = m_View.nodeKeys;
    }
  }

  void
  AddEdges()
  {
    Json starts = Json::array();
    Json touches = Json::array();
    Json edgeOf = Json::array();
    for (int h = 0; h < m_Graph.map.HalfEdges(); ++h)
    {
      if (m_Graph.isVisibleEdge[h / 2] != 0)
      {
        starts.push_back(m_Graph.map.Node(h));
        this->Append(touches, m_Graph.touch[h]);
        edgeOf.push_back(m_Graph.edgeOf[h / 2]);
      }
    }
    m_Data["starts"] = std::move(starts);
    m_Data["touches"] = std::move(touches);
    m_Data["edgeOf"] = std::move(edgeOf);
    if (!m_View.edgeColors.empty())
    {
      m_Data["edgeColors"] = m_View.edgeColors;
    }
    Json ends = Json::array();
    for (const auto & edge : m_View.certificate->graph.edges)
    {
      ends.push_back(edge[0]);
      ends.push_back(edge[1]);
    }
    m_Data["ends"] = std::move(ends);
  }

  void
  AddFaces()
  {
    Json faces = Json::array();
    Json radii = Json::array();
    for (std::size_t face = 0; face < m_Graph.faces.size(); ++face)
    {
      if (m_Graph.isVisibleFace[face] != 0)
      {
        this->Append(faces, m_Graph.faces[face]);
        radii.push_back(Rounded(m_View.certificate->faceRadii[face]));
      }
    }
    m_Data["faces"] = std::move(faces);
    m_Data["faceRadii"] = std::move(radii);
    Json dual = Json::array();
    for (const auto & segment : m_Graph.dual)
    {
      this->Append(dual, segment[0]);
      this->Append(dual, segment[1]);
    }
    m_Data["dual"] = std::move(dual);
  }

  Json
  Tiles() const
  {
    constexpr double mostSegments = 60000.0; // limit for interactive painting on a canvas
    const double     segments = static_cast<double>(m_Graph.halfEdges.size() + 1);
    const double     least = 4.0 * m_View.certificate->genus + 1.0;
    const int        count = static_cast<int>(std::clamp(mostSegments / segments, least, std::max(least, 120.0)));
    Json             tiles = Json::array();
    for (const Motion & tile : TilesAround(m_Graph, count))
    {
      for (const double number : { tile.a.real(), tile.a.imag(), tile.b.real(), tile.b.imag() })
      {
        tiles.push_back(Rounded(number));
      }
    }
    return tiles;
  }

  /** Adds the tiles, the boundary of the domain, and the center of the view (on the sphere, the front). */
  void
  AddCover()
  {
    m_Data["tiles"] = this->Tiles();
    const std::vector<Place> boundary = DomainBoundary(m_Graph);
    m_Data["domain"] = this->PlacesOf(boundary);
    if (this->IsSphere())
    {
      m_Data["front"] = this->PlacesOf({ m_Graph.front });
    }
    if (m_Graph.space.Geometry() == EmbeddingGeometry::Euclidean)
    {
      Place middle;
      for (const Place & place : boundary)
      {
        middle.x += place.x / static_cast<double>(boundary.size());
        middle.y += place.y / static_cast<double>(boundary.size());
      }
      double extent = 0.0;
      for (const Place & place : boundary)
      {
        constexpr double withMargin = 1.2;
        extent = std::max(extent, withMargin * std::hypot(place.x - middle.x, place.y - middle.y));
      }
      m_Data["middle"] = this->PlacesOf({ middle });
      m_Data["extent"] = Rounded(extent);
    }
  }

  const GraphView & m_View;
  EmbeddedGraph     m_Graph;
  Json              m_Data;
};
} // namespace

Json
PageDataOf(const GraphView & view)
{
  return PageData(view).Take();
}
} // namespace shapeton
