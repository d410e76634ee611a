#include "shapetonGenusGenetic.h"

#include "shapetonGraphStructure.h"

#include <algorithm>
#include <utility>

namespace shapeton
{
namespace
{
constexpr int population = 24;
constexpr int mostMutations = 3;

class GeneticSearch
{
public:
  GeneticSearch(const Graph & graph, PhiloxStream random)
    : m_Incidence(graph)
    , m_Nodes(graph.nodes)
    , m_Random(random)
    , m_Previous(2 * graph.edges.size())
    , m_Face(2 * graph.edges.size())
  {
    for (int i = 0; i < population; ++i)
    {
      m_Members.push_back({ m_Incidence.halfEdges, 0 });
      for (int v = 0; v < m_Nodes; ++v)
      {
        Shuffle(m_Members.back().orders, v);
      }
      m_Members.back().faces = CountFaces(m_Members.back().orders);
    }
  }

  void
  Breed()
  {
    Member child = m_Members[Winner()];
    Cross(child.orders, m_Members[Winner()].orders);
    CountFaces(child.orders);
    Mutate(child.orders);
    child.faces = CountFaces(child.orders);
    Member & worst = *std::min_element(m_Members.begin(), m_Members.end(), HasFewerFaces);
    if (child.faces >= worst.faces)
    {
      worst = std::move(child);
    }
  }

  std::vector<int>
  BestNextAround() const
  {
    const Member &   best = *std::max_element(m_Members.begin(), m_Members.end(), HasFewerFaces);
    std::vector<int> next(best.orders.size());
    for (int v = 0; v < m_Nodes; ++v)
    {
      const int start = m_Incidence.start[v];
      const int degree = m_Incidence.Degree(v);
      for (int i = 0; i < degree; ++i)
      {
        next[best.orders[start + i]] = best.orders[start + (i + 1) % degree];
      }
    }
    return next;
  }

private:
  /** The half-edges around all nodes, in the places of the incidence. */
  struct Member
  {
    std::vector<int> orders;
    int              faces;
  };

  static bool
  HasFewerFaces(const Member & a, const Member & b)
  {
    return a.faces < b.faces;
  }

  void
  Shuffle(std::vector<int> & orders, int node)
  {
    for (int i = m_Incidence.Degree(node); i > 1; --i)
    {
      std::swap(orders[m_Incidence.start[node] + i - 1], orders[m_Incidence.start[node] + m_Random.Below(i)]);
    }
  }

  int
  Winner()
  {
    const int a = m_Random.Below(population);
    const int b = m_Random.Below(population);
    return m_Members[a].faces > m_Members[b].faces ? a : b;
  }

  void
  Cross(std::vector<int> & child, const std::vector<int> & parent)
  {
    for (int v = 0; v < m_Nodes; ++v)
    {
      if (m_Random.Below(2) == 1)
      {
        std::copy(parent.begin() + m_Incidence.start[v],
                  parent.begin() + m_Incidence.start[v + 1],
                  child.begin() + m_Incidence.start[v]);
      }
    }
  }

  int
  CountFaces(const std::vector<int> & orders)
  {
    for (int v = 0; v < m_Nodes; ++v)
    {
      const int start = m_Incidence.start[v];
      const int degree = m_Incidence.Degree(v);
      for (int i = 0; i < degree; ++i)
      {
        m_Previous[orders[start + (i + 1) % degree]] = orders[start + i];
      }
    }
    std::fill(m_Face.begin(), m_Face.end(), -1);
    int faces = 0;
    for (std::size_t h = 0; h < m_Face.size(); ++h)
    {
      if (m_Face[h] < 0)
      {
        for (int x = static_cast<int>(h); m_Face[x] < 0; x = m_Previous[x ^ 1])
        {
          m_Face[x] = faces;
        }
        ++faces;
      }
    }
    return faces;
  }

  /** The set Omega of section 6.3.1. */
  std::vector<int>
  NodesSeveralTimesInAFace(const std::vector<int> & orders) const
  {
    std::vector<int> result;
    std::vector<int> faces;
    for (int v = 0; v < m_Nodes; ++v)
    {
      faces.clear();
      for (int i = m_Incidence.start[v]; i < m_Incidence.start[v + 1]; ++i)
      {
        faces.push_back(m_Face[orders[i]]);
      }
      std::sort(faces.begin(), faces.end());
      if (std::adjacent_find(faces.begin(), faces.end()) != faces.end())
      {
        result.push_back(v);
      }
    }
    return result;
  }

  void
  Mutate(std::vector<int> & orders)
  {
    const std::vector<int> candidates = NodesSeveralTimesInAFace(orders);
    if (candidates.empty())
    {
      return;
    }
    for (int mutations = 1 + m_Random.Below(mostMutations); mutations > 0; --mutations)
    {
      const int v = candidates[m_Random.Below(static_cast<int>(candidates.size()))];
      if (m_Random.Below(2) == 1)
      {
        Shuffle(orders, v);
      }
      else
      {
        int *     order = orders.data() + m_Incidence.start[v];
        const int other = m_Random.Below(m_Incidence.Degree(v));
        std::swap(order[m_Random.Below(m_Incidence.Degree(v))], order[other]);
      }
    }
  }

  Incidence           m_Incidence;
  int                 m_Nodes;
  PhiloxStream        m_Random;
  std::vector<int>    m_Previous;
  std::vector<int>    m_Face;
  std::vector<Member> m_Members;
};
} // namespace

std::vector<int>
SearchGenetically(const Graph &                 graph,
                  PhiloxStream                  random,
                  std::int64_t                  children,
                  const std::function<bool()> & isInVain)
{
  GeneticSearch search(graph, random);
  for (std::int64_t i = 0; i < children && !isInVain(); ++i)
  {
    search.Breed();
  }
  return search.BestNextAround();
}
} // namespace shapeton
