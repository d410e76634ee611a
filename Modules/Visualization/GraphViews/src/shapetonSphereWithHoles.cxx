#include "shapetonSphereWithHoles.h"
#include "shapetonPathsOfEdges.h"

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

/** New vertices at edge midpoints; -1 if an edge is not split. */
class EdgeMiddles
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

/** Triangulates a sphere with holes. */
class SphereTriangulation
{
public:
  SphereTriangulation(const PackedMap &               packed,
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

  /** To be called once. */
  SphereWithHoles
  Take()
  {
    return std::move(m_Sphere);
  }

private:
  int
  Add(const Eigen::Vector3d & vertex, int rim = -1)
  {
    m_Sphere.vertices.push_back(vertex);
    m_Sphere.rims.push_back(rim);
    return static_cast<int>(m_Sphere.vertices.size()) - 1;
  }

  /** Point of a rim in the direction of a point of the sphere. */
  int
  AddRim(int hole, const Eigen::Vector3d & towards)
  {
    const auto & [node, center, angle] = m_Holes[hole];
    const Eigen::Vector3d direction = (towards - towards.dot(center) * center).normalized();
    return this->Add(std::cos(angle) * center + std::sin(angle) * direction, hole);
  }

  void
  AddVertices(const SphericalPacking & packing)
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
        m_RimAtTouch[h] = this->AddRim(hole, m_Sphere.vertices[m_OfTouch[h / 2]]);
        m_RimAtFace[h] = this->AddRim(hole, m_Sphere.vertices[m_OfFace[m_Map.Face(h)]]);
      }
    }
  }

  /** Adds both sides of each half-edge: its face to the left, the previous half-edge's face to the right. */
  void
  AddTriangles()
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
        m_Sphere.triangles.push_back({ node, touch, left });
        m_Sphere.triangles.push_back({ node, right, touch });
      }
      else
      {
        m_Sphere.triangles.push_back({ m_RimAtTouch[h], touch, left });
        m_Sphere.triangles.push_back({ m_RimAtTouch[h], left, m_RimAtFace[h] });
        m_Sphere.triangles.push_back({ m_RimAtFace[before], right, touch });
        m_Sphere.triangles.push_back({ m_RimAtFace[before], touch, m_RimAtTouch[h] });
      }
    }
  }

  void
  AddPaths(const PackedMap & packed)
  {
    const auto startOf = [this](int h) {
      const int node = m_OfNode[m_Map.Node(h)];
      return node >= 0 ? node : m_RimAtTouch[h];
    };
    for (const std::vector<int> & path : PathsOfEdges(packed.graphEdges, packed.subdivided))
    {
      std::vector<int> vertices{ startOf(path.front()) };
      for (const int h : path)
      {
        vertices.push_back(m_OfTouch[h / 2]);
        vertices.push_back(startOf(CombinatorialMap::Twin(h)));
      }
      m_Sphere.paths.push_back(vertices);
    }
  }

  bool
  IsTooLong(int i, int j) const
  {
    const double length = (m_Sphere.vertices[i] - m_Sphere.vertices[j]).norm();
    const bool   isOnRim = m_Sphere.rims[i] >= 0 && m_Sphere.rims[i] == m_Sphere.rims[j];
    return length > m_Longest || (isOnRim && length > longestOnRim * std::sin(m_Holes[m_Sphere.rims[i]].angle));
  }

  int
  Middle(int i, int j)
  {
    const Eigen::Vector3d middle = (m_Sphere.vertices[i] + m_Sphere.vertices[j]).normalized();
    return m_Sphere.rims[i] >= 0 && m_Sphere.rims[i] == m_Sphere.rims[j] ? this->AddRim(m_Sphere.rims[i], middle)
                                                                         : this->Add(middle);
  }

  /** Bisects all edges that are too long, once. Returns whether there were any. */
  bool
  Refine()
  {
    EdgeMiddles middles;
    for (const std::array<int, 3> & triangle : m_Sphere.triangles)
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
    whole.swap(m_Sphere.triangles);
    for (const std::array<int, 3> & triangle : whole)
    {
      this->AddParts(triangle, middles);
    }
    for (std::vector<int> & path : m_Sphere.paths)
    {
      path = Halved(path, middles);
    }
    return true;
  }

  /** Adds the parts of a triangle whose split edges have these midpoints. */
  void
  AddParts(std::array<int, 3> t, const EdgeMiddles & middles)
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
      m_Sphere.triangles.push_back(t);
    }
    else if (bc < 0)
    {
      m_Sphere.triangles.insert(m_Sphere.triangles.end(), { { t[0], ab, t[2] }, { ab, t[1], t[2] } });
    }
    else if (ca < 0)
    {
      const bool isFirst = (m_Sphere.vertices[t[0]] - m_Sphere.vertices[bc]).norm() <=
                           (m_Sphere.vertices[ab] - m_Sphere.vertices[t[2]]).norm();
      m_Sphere.triangles.push_back({ ab, t[1], bc });
      m_Sphere.triangles.push_back({ t[0], ab, isFirst ? bc : t[2] });
      m_Sphere.triangles.push_back({ isFirst ? t[0] : ab, bc, t[2] });
    }
    else
    {
      m_Sphere.triangles.insert(m_Sphere.triangles.end(),
                                { { t[0], ab, ca }, { ab, t[1], bc }, { ca, bc, t[2] }, { ab, bc, ca } });
    }
  }

  static std::vector<int>
  Halved(const std::vector<int> & path, const EdgeMiddles & middles)
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

  const CombinatorialMap &        m_Map;
  const std::vector<SphereHole> & m_Holes;
  double                          m_Longest;

  SphereWithHoles m_Sphere;

  /** \name Vertices of the packing. Half-edges at a node with a hole have rim vertices, in the directions of tangency
   * point and face.
   */
  ///@{
  std::vector<int> m_HoleOfNode;
  std::vector<int> m_OfNode;
  std::vector<int> m_OfFace;
  std::vector<int> m_OfTouch;
  std::vector<int> m_RimAtTouch;
  std::vector<int> m_RimAtFace;
  ///@}
};
} // namespace

SphereWithHoles
TriangulateSphere(const PackedMap &               packed,
                  const SphericalPacking &        packing,
                  const std::vector<SphereHole> & holes,
                  double                          longest)
{
  return SphereTriangulation(packed, packing, holes, longest).Take();
}

} // namespace shapeton
