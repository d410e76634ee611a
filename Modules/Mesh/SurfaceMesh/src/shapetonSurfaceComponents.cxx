#include "shapetonFanWalk.h"
#include "shapetonDisjointSets.h"
#include "shapetonParallelFor.h"

#include <algorithm>

namespace shapeton
{
// Faces that share an edge form a component, represented by its lowest face.
void
SurfaceConnectivity::BuildComponents()
{
  DisjointSets<int> sets(m_Faces.rows());
  for (int e = 0; e < this->NumberOfEdges(); ++e)
  {
    const IndexRange faces = this->FacesOfEdge(e);
    for (const int face : faces)
    {
      sets.Join(faces[0], face);
    }
  }
  m_ComponentOfFace.assign(m_Faces.rows(), -1);
  for (int f = 0; f < this->NumberOfFaces(); ++f)
  {
    if (m_FaceEdges[3 * f] < 0)
    {
      continue;
    }
    const int least = sets.Find(f);
    if (least == f)
    {
      m_ComponentOfFace[f] = static_cast<int>(m_Components.size());
      m_Components.emplace_back();
      m_Components.back().firstFace = f;
    }
    m_ComponentOfFace[f] = m_ComponentOfFace[least];
  }
  this->TurnFaces();
}

void
SurfaceConnectivity::TurnFaces()
{
  m_IsTurned.assign(m_Faces.rows(), false);
  if (this->IsOriented())
  {
    return;
  }
  std::vector<bool> isReached(m_Faces.rows(), false);
  std::vector<int>  open;
  for (int seed = 0; seed < this->NumberOfFaces(); ++seed)
  {
    if (isReached[seed] || m_ComponentOfFace[seed] < 0)
    {
      continue;
    }
    isReached[seed] = true;
    open.assign(1, seed);
    while (!open.empty())
    {
      const int f = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const int        edge = m_FaceEdges[3 * f + k];
        const IndexRange faces = this->FacesOfEdge(edge);
        if (faces.size() != 2)
        {
          continue;
        }
        const int  g = faces[0] == f ? faces[1] : faces[0];
        const bool isTurned = m_IsTurned[f] != this->IsInconsistentEdge(edge);
        if (!isReached[g])
        {
          isReached[g] = true;
          m_IsTurned[g] = isTurned;
          open.push_back(g);
        }
        else if (m_IsTurned[g] != isTurned)
        {
          m_Components[m_ComponentOfFace[f]].isOrientable = false;
        }
      }
    }
  }
}

// A vertex counts once for each component with a face at it.
void
SurfaceConnectivity::CountVertices()
{
  std::vector<char> isOneFan(m_NumberOfVertices);
  ParallelForBlocks(isOneFan.size(),
                    [&](std::size_t v) { isOneFan[v] = IsOneFan(*this, m_Faces, static_cast<int>(v)) ? 1 : 0; });
  std::vector<int> components;
  for (int v = 0; v < m_NumberOfVertices; ++v)
  {
    const IndexRange faces = this->FacesOfVertex(v);
    if (isOneFan[v] != 0)
    {
      ++m_Components[m_ComponentOfFace[faces[0]]].vertices;
      continue;
    }
    const std::vector<int> fan = this->FanOfFaces(v);
    components.clear();
    int fans = 0;
    for (int i = 0; i < faces.size(); ++i)
    {
      if (fan[i] == fans) // first face of another fan
      {
        ++fans;
        const int component = m_ComponentOfFace[faces[i]];
        if (std::find(components.begin(), components.end(), component) != components.end())
        {
          m_Components[component].isManifold = false;
          continue;
        }
        components.push_back(component);
        ++m_Components[component].vertices;
      }
    }
  }
}

void
SurfaceConnectivity::CountComponents()
{
  for (const int component : m_ComponentOfFace)
  {
    if (component >= 0)
    {
      ++m_Components[component].faces;
    }
  }
  for (int e = 0; e < this->NumberOfEdges(); ++e)
  {
    SurfaceComponent & component = m_Components[m_ComponentOfFace[this->FacesOfEdge(e)[0]]];
    ++component.edges;
    component.isManifold = component.isManifold && !this->IsNonManifoldEdge(e);
  }
  this->CountVertices();
  for (const auto & loop : m_Loops)
  {
    const int edge = this->FindEdge(loop[0], loop[1]);
    ++m_Components[m_ComponentOfFace[this->FacesOfEdge(edge)[0]]].boundaryLoops;
  }
  for (SurfaceComponent & component : m_Components)
  {
    component.eulerCharacteristic = component.vertices - component.edges + component.faces;
    if (component.isManifold && component.isOrientable)
    {
      component.genus = (2 - component.boundaryLoops - component.eulerCharacteristic) / 2;
    }
  }
}

// The boundary edge after `edge` at `vertex`, around the fan of its face; -1 at a non-manifold edge.
int
SurfaceConnectivity::NextBoundaryEdge(int edge, int vertex) const
{
  int face = this->FacesOfEdge(edge)[0];
  for (;;)
  {
    int next = -1;
    for (int k = 0; k < 3; ++k)
    {
      const int  candidate = m_FaceEdges[3 * face + k];
      const auto ends = m_EdgeVertices[candidate];
      if (candidate != edge && (ends[0] == vertex || ends[1] == vertex))
      {
        next = candidate;
      }
    }
    const IndexRange faces = this->FacesOfEdge(next);
    if (faces.size() != 2)
    {
      return faces.size() == 1 ? next : -1;
    }
    face = faces[0] == face ? faces[1] : faces[0];
    edge = next;
  }
}

void
SurfaceConnectivity::BuildLoops()
{
  std::vector<bool> isDone(m_EdgeVertices.size(), false);
  for (int first = 0; first < this->NumberOfEdges(); ++first)
  {
    if (isDone[first] || !this->IsBoundaryEdge(first))
    {
      continue;
    }
    auto [from, to] = m_EdgeVertices[first];
    if (!this->RunsForward(this->FacesOfEdge(first)[0], first))
    {
      std::swap(from, to);
    }
    std::vector<int> loop{ from };
    isDone[first] = true;
    int edge = this->NextBoundaryEdge(first, to);
    while (edge >= 0 && !isDone[edge])
    {
      loop.push_back(to);
      isDone[edge] = true;
      to = m_EdgeVertices[edge][0] == to ? m_EdgeVertices[edge][1] : m_EdgeVertices[edge][0];
      edge = this->NextBoundaryEdge(edge, to);
    }
    if (edge == first)
    {
      std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    }
    else
    {
      loop.push_back(to); // an open chain
    }
    m_Loops.push_back(std::move(loop));
  }
}
} // namespace shapeton
