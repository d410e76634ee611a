#include "shapetonCutDisc.h"

#include "shapetonInterruption.h"

#include <algorithm>
#include <queue>
#include <unordered_map>
#include <unordered_set>

namespace shapeton
{
namespace
{
/** Maximum number of faces of an enclosed island relative to that of the surrounding disc. */
constexpr std::size_t GreatestIsland = 4;
} // namespace

std::vector<int>
DiscCutter::FindDisc(int pole, double radius, int outside) const
{
  std::vector<int> faces = this->FacesWithin(pole, radius);
  this->FillIslands(faces, outside);
  this->FillTeeth(faces);
  std::sort(faces.begin(), faces.end());
  return this->IsDisc(faces) ? faces : std::vector<int>();
}

void
DiscCutter::Forbid(const std::vector<int> & faces)
{
  for (const int face : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      for (const int other : m_Connectivity.FacesOfVertex(m_Mesh.F(face, k)))
      {
        m_IsForbidden[other] = 1;
      }
    }
  }
}

int
DiscCutter::FaceAcross(int face, int k) const
{
  const IndexRange faces = m_Connectivity.FacesOfEdge(m_Connectivity.EdgeOfFace(face, k));
  return faces[0] == face ? faces[1] : faces[0];
}

std::vector<int>
DiscCutter::FacesWithin(int pole, double radius) const
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::unordered_map<int, double>                                distances{ { pole, 0.0 } };
  std::vector<int>                                               reached;
  queue.emplace(0.0, pole);
  while (!queue.empty())
  {
    Interruption::Check();
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distances[vertex])
    {
      continue;
    }
    reached.push_back(vertex);
    for (const int other : m_Connectivity.NeighborsOfVertex(vertex))
    {
      const double further = distance + (m_Mesh.V.row(other) - m_Mesh.V.row(vertex)).norm();
      const auto   known = distances.find(other);
      if (further <= radius && (known == distances.end() || further < known->second))
      {
        distances[other] = further;
        queue.emplace(further, other);
      }
    }
  }
  std::unordered_set<int> isTaken;
  std::vector<int>        faces;
  for (const int vertex : reached)
  {
    for (const int face : m_Connectivity.FacesOfVertex(vertex))
    {
      const bool isInside =
        distances.count(m_Mesh.F(face, 0)) + distances.count(m_Mesh.F(face, 1)) + distances.count(m_Mesh.F(face, 2)) ==
        3;
      if (isInside && isTaken.insert(face).second)
      {
        faces.push_back(face);
      }
    }
  }
  return faces;
}

bool
DiscCutter::HasVertex(int face, int vertex) const
{
  return m_Mesh.F(face, 0) == vertex || m_Mesh.F(face, 1) == vertex || m_Mesh.F(face, 2) == vertex;
}

void
DiscCutter::FillIslands(std::vector<int> & faces, int outsideVertex) const
{
  std::unordered_set<int> disc(faces.begin(), faces.end());
  std::unordered_set<int> outside;
  const std::size_t       greatest = GreatestIsland * faces.size();
  const std::size_t       number = faces.size();
  for (std::size_t i = 0; i < 3 * number; ++i)
  {
    const int start = this->FaceAcross(faces[i / 3], static_cast<int>(i % 3));
    if (disc.count(start) + outside.count(start) != 0)
    {
      continue;
    }
    std::vector<int>        island{ start };
    std::unordered_set<int> seen{ start };
    bool                    isOutside = false;
    for (std::size_t next = 0; next < island.size() && !isOutside; ++next)
    {
      isOutside =
        island.size() > greatest || outside.count(island[next]) != 0 || this->HasVertex(island[next], outsideVertex);
      for (int side = 0; side < 3; ++side)
      {
        const int other = this->FaceAcross(island[next], side);
        if (disc.count(other) == 0 && seen.insert(other).second)
        {
          island.push_back(other);
        }
      }
    }
    (isOutside ? outside : disc).insert(island.begin(), island.end());
    if (!isOutside)
    {
      faces.insert(faces.end(), island.begin(), island.end());
    }
  }
}

/** Adds faces with two edges on the disc, which would protrude into the opening. */
void
DiscCutter::FillTeeth(std::vector<int> & faces) const
{
  std::unordered_set<int> disc(faces.begin(), faces.end());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int candidate = this->FaceAcross(faces[i], k);
      int       edges = 0;
      for (int side = 0; side < 3; ++side)
      {
        edges += disc.count(this->FaceAcross(candidate, side)) != 0 ? 1 : 0;
      }
      if (edges >= 2 && disc.insert(candidate).second)
      {
        faces.push_back(candidate);
      }
    }
  }
}

bool
DiscCutter::IsDisc(const std::vector<int> & faces) const
{
  if (faces.empty() || std::any_of(faces.begin(), faces.end(), [this](int face) { return m_IsForbidden[face] != 0; }))
  {
    return false;
  }
  std::unordered_map<int, int> numbers;
  FaceMatrix                   F(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      F(static_cast<Eigen::Index>(i), k) =
        numbers.emplace(m_Mesh.F(faces[i], k), static_cast<int>(numbers.size())).first->second;
    }
  }
  const SurfaceConnectivity patch(F, static_cast<int>(numbers.size()));
  return patch.Components().size() == 1 && patch.IsManifold() && patch.BoundaryLoops().size() == 1 &&
         patch.Components().front().eulerCharacteristic == 1;
}
} // namespace shapeton
