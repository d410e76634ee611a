#include "shapetonSphereWithHoles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace shapeton
{
namespace
{
/** Maximum edge length of a rim, in radii of the hole. */
constexpr double longestOnRim = 0.45;

Eigen::Vector3d
VectorOf(const std::array<double, 3> & point)
{
  return { point[0], point[1], point[2] };
}
} // namespace

/** New vertices at edge midpoints; -1 if an edge is not split. */
class SphereWithHoles::EdgeMiddles
{
public:
  int
  operator()(int i, int j) const
  {
    const auto found = m_Middles.find(KeyOf(i, j));
    return found == m_Middles.end() ? -1 : found->second;
  }
  void
  Set(int i, int j, int middle)
  {
    m_Middles[KeyOf(i, j)] = middle;
  }
  bool
  IsEmpty() const
  {
    return m_Middles.empty();
  }

private:
  static std::uint64_t
  KeyOf(int i, int j)
  {
    return static_cast<std::uint64_t>(std::min(i, j)) << 32 | static_cast<std::uint64_t>(std::max(i, j));
  }
  std::unordered_map<std::uint64_t, int> m_Middles;
};

SphereWithHoles::SphereWithHoles(const PackedMap &               packed,
                                 const SphericalPacking &        packing,
                                 const std::vector<SphereHole> & holes,
                                 double                          longest)
  : m_Map(packed.map), m_Holes(holes), m_Longest(longest), m_HoleOfNode(packed.map.Nodes(), -1)
{
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    m_HoleOfNode[holes[i].node] = static_cast<int>(i);
  }
  this->AddVertices(packing);
  this->AddTriangles();
  this->AddPaths(packed);
  while (this->Refine())
  {}
}

int
SphereWithHoles::Add(const Eigen::Vector3d & vertex, int rim)
{
  m_Vertices.push_back(vertex);
  m_Rims.push_back(rim);
  return static_cast<int>(m_Vertices.size()) - 1;
}

/** Point of a rim in the direction of a point of the sphere. */
int
SphereWithHoles::AddRim(int hole, const Eigen::Vector3d & towards)
{
  const auto & [node, center, angle] = m_Holes[hole];
  const Eigen::Vector3d direction = (towards - towards.dot(center) * center).normalized();
  return this->Add(std::cos(angle) * center + std::sin(angle) * direction, hole);
}

void
SphereWithHoles::AddVertices(const SphericalPacking & packing)
{
  m_OfNode.assign(m_Map.Nodes(), -1);
  m_RimAtTouch.assign(m_Map.HalfEdges(), -1);
  m_RimAtFace.assign(m_Map.HalfEdges(), -1);
  for (int node = 0; node < m_Map.Nodes(); ++node)
  {
    if (m_HoleOfNode[node] < 0)
    {
      m_OfNode[node] = this->Add(VectorOf(CenterOf(packing.nodes[node])));
    }
  }
  for (const SphereCircle & face : packing.faces)
  {
    m_OfFace.push_back(this->Add(VectorOf(CenterOf(face))));
  }
  for (const std::array<double, 3> & touch : packing.touchPoints)
  {
    m_OfTouch.push_back(this->Add(VectorOf(touch)));
  }
  for (int h = 0; h < m_Map.HalfEdges(); ++h)
  {
    const int hole = m_HoleOfNode[m_Map.Node(h)];
    if (hole >= 0)
    {
      m_RimAtTouch[h] = this->AddRim(hole, m_Vertices[m_OfTouch[h / 2]]);
      m_RimAtFace[h] = this->AddRim(hole, m_Vertices[m_OfFace[m_Map.Face(h)]]);
    }
  }
}

/** Adds both sides of each half-edge: its face to the left, the previous half-edge's face to the right. */
void
SphereWithHoles::AddTriangles()
{
  for (int h = 0; h < m_Map.HalfEdges(); ++h)
  {
    const int before = m_Map.PreviousAround(h);
    const int node = m_OfNode[m_Map.Node(h)];
    const int touch = m_OfTouch[h / 2];
    const int left = m_OfFace[m_Map.Face(h)];
    const int right = m_OfFace[m_Map.Face(before)];
    if (node >= 0)
    {
      m_Triangles.push_back({ node, touch, left });
      m_Triangles.push_back({ node, right, touch });
    }
    else
    {
      m_Triangles.push_back({ m_RimAtTouch[h], touch, left });
      m_Triangles.push_back({ m_RimAtTouch[h], left, m_RimAtFace[h] });
      m_Triangles.push_back({ m_RimAtFace[before], right, touch });
      m_Triangles.push_back({ m_RimAtFace[before], touch, m_RimAtTouch[h] });
    }
  }
}

void
SphereWithHoles::AddPaths(const PackedMap & packed)
{
  std::vector<std::vector<int>> paths(packed.graphEdges);
  for (int edge = 0; edge < packed.graphEdges; ++edge)
  {
    paths[edge] = { 2 * edge };
  }
  for (const std::vector<int> & path : packed.subdivided)
  {
    paths[path.front() / 2] = path;
  }
  const auto startOf = [this](int h) {
    const int node = m_OfNode[m_Map.Node(h)];
    return node >= 0 ? node : m_RimAtTouch[h];
  };
  for (const std::vector<int> & path : paths)
  {
    std::vector<int> vertices{ startOf(path.front()) };
    for (const int h : path)
    {
      vertices.push_back(m_OfTouch[h / 2]);
      vertices.push_back(startOf(CombinatorialMap::Twin(h)));
    }
    m_Paths.push_back(vertices);
  }
}

bool
SphereWithHoles::IsTooLong(int i, int j) const
{
  const double length = (m_Vertices[i] - m_Vertices[j]).norm();
  const bool   isOnRim = m_Rims[i] >= 0 && m_Rims[i] == m_Rims[j];
  return length > m_Longest || (isOnRim && length > longestOnRim * std::sin(m_Holes[m_Rims[i]].angle));
}

int
SphereWithHoles::Middle(int i, int j)
{
  const Eigen::Vector3d middle = (m_Vertices[i] + m_Vertices[j]).normalized();
  return m_Rims[i] >= 0 && m_Rims[i] == m_Rims[j] ? this->AddRim(m_Rims[i], middle) : this->Add(middle);
}

std::vector<int>
SphereWithHoles::Halved(const std::vector<int> & path, const EdgeMiddles & middles)
{
  std::vector<int> finer{ path.front() };
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const int middle = middles(path[i - 1], path[i]);
    if (middle >= 0)
    {
      finer.push_back(middle);
    }
    finer.push_back(path[i]);
  }
  return finer;
}

/** Bisects all edges that are too long, once. Returns whether there were any. */
bool
SphereWithHoles::Refine()
{
  EdgeMiddles middles;
  for (const std::array<int, 3> & triangle : m_Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int i = triangle[k];
      const int j = triangle[(k + 1) % 3];
      if (this->IsTooLong(i, j) && middles(i, j) < 0)
      {
        middles.Set(i, j, this->Middle(i, j));
      }
    }
  }
  if (middles.IsEmpty())
  {
    return false;
  }
  std::vector<std::array<int, 3>> whole;
  whole.swap(m_Triangles);
  for (const std::array<int, 3> & triangle : whole)
  {
    this->AddParts(triangle, middles);
  }
  for (std::vector<int> & path : m_Paths)
  {
    path = Halved(path, middles);
  }
  return true;
}

/** Adds the parts of a triangle whose split edges have these midpoints. */
void
SphereWithHoles::AddParts(std::array<int, 3> t, const EdgeMiddles & middles)
{
  // In a mixed triangle, a split edge is first and an unsplit one last.
  for (int turn = 0; turn < 3 && (middles(t[0], t[1]) < 0 || middles(t[2], t[0]) >= 0); ++turn)
  {
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  const int ab = middles(t[0], t[1]);
  const int bc = middles(t[1], t[2]);
  const int ca = middles(t[2], t[0]);
  if (ab < 0)
  {
    m_Triangles.push_back(t);
  }
  else if (bc < 0)
  {
    m_Triangles.insert(m_Triangles.end(), { { t[0], ab, t[2] }, { ab, t[1], t[2] } });
  }
  else if (ca < 0)
  {
    const bool isFirst = (m_Vertices[t[0]] - m_Vertices[bc]).norm() <= (m_Vertices[ab] - m_Vertices[t[2]]).norm();
    m_Triangles.push_back({ ab, t[1], bc });
    m_Triangles.push_back({ t[0], ab, isFirst ? bc : t[2] });
    m_Triangles.push_back({ isFirst ? t[0] : ab, bc, t[2] });
  }
  else
  {
    m_Triangles.insert(m_Triangles.end(), { { t[0], ab, ca }, { ab, t[1], bc }, { ca, bc, t[2] }, { ab, bc, ca } });
  }
}
} // namespace shapeton
