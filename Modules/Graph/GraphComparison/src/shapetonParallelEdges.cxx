#include "shapetonParallelEdges.h"

#include "shapetonGraphStructure.h"

#include <algorithm>
#include <map>

namespace shapeton
{
namespace
{
/** Paths along dummies, by edge. */
std::map<int, std::vector<int>>
PathsOf(const PackedMap & packed)
{
  std::map<int, std::vector<int>> paths;
  for (const std::vector<int> & path : packed.subdivided)
  {
    paths[path.front() / 2] = path;
  }
  return paths;
}

/** Numbers that put `front` first and keep the order of the others. */
std::vector<int>
NumbersWithFirst(const std::vector<int> & front, int first, int size)
{
  std::vector<int> numbers(size, -1);
  for (int i = 0; i < first; ++i)
  {
    numbers[i] = i;
  }
  int next = first;
  for (const int element : front)
  {
    numbers[element] = next++;
  }
  for (int & number : numbers)
  {
    number = number < 0 ? next++ : number;
  }
  return numbers;
}
} // namespace

ParallelEdges::ParallelEdges(const Graph & graph)
  : m_Nodes(graph.nodes), m_Edges(static_cast<int>(graph.edges.size())), m_Simple(graph)
{
  const std::vector<int> first = FirstParallels(graph);
  std::map<int, int>     copies;
  for (int e = 0; e < m_Edges; ++e)
  {
    if (first[e] == e)
    {
      continue;
    }
    if (m_Parallel.empty())
    {
      for (int node = static_cast<int>(m_Simple.names.size()); node < m_Nodes; ++node)
      {
        m_Simple.names.push_back(NameOfNode(graph, node));
      }
    }
    auto [a, b] = graph.edges[e];
    m_Simple.edges[e][1] = m_Simple.nodes;
    m_Simple.edges.push_back({ m_Simple.nodes++, b });
    m_Parallel.push_back(e);
    const auto [low, high] = std::minmax(m_Simple.names[a], m_Simple.names[b]);
    m_Simple.names.push_back('\n' + low + '\n' + high + '\n' + std::to_string(++copies[first[e]]));
  }
}

CombinatorialMap
ParallelEdges::Simple(const CombinatorialMap & map) const
{
  Rotation rotation = map.GetRotation();
  for (std::size_t j = 0; j < m_Parallel.size(); ++j)
  {
    const int last = 2 * m_Parallel[j] + 1;
    const int second = 2 * (m_Edges + static_cast<int>(j));
    auto &    around = rotation[map.Node(last)];
    *std::find(around.begin(), around.end(), last) = second + 1;
    rotation.push_back({ last, second });
  }
  return { m_Simple, rotation };
}

PackedMap
ParallelEdges::Simple(const PackedMap & packed) const
{
  const CombinatorialMap & map = packed.map;
  auto                     paths = PathsOf(packed);
  std::vector<int>         middles;
  std::vector<int>         seconds;
  std::vector<char>        isTurned(map.Edges(), 0);
  for (const int e : m_Parallel)
  {
    const int half = paths.at(e)[1];
    middles.push_back(map.Node(half));
    seconds.push_back(half / 2);
    isTurned[half / 2] = half % 2;
  }
  const auto nodes = NumbersWithFirst(middles, m_Nodes, map.Nodes());
  const auto edges = NumbersWithFirst(seconds, m_Edges, map.Edges());
  const auto halfOf = [&](int h) { return 2 * edges[h / 2] + (h % 2 ^ isTurned[h / 2]); };
  Graph      graph{ map.Nodes(), std::vector<std::array<int, 2>>(map.Edges()), {} };
  Rotation   rotation(map.Nodes());
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    graph.edges[halfOf(h) / 2][halfOf(h) % 2] = nodes[map.Node(h)];
  }
  for (int node = 0; node < map.Nodes(); ++node)
  {
    for (const int h : map.Around(node))
    {
      rotation[nodes[node]].push_back(halfOf(h));
    }
  }
  PackedMap result{
    CombinatorialMap(graph, rotation), m_Simple.nodes, static_cast<int>(m_Simple.edges.size()), {}, packed.rings
  };
  for (const auto & [edge, path] : paths)
  {
    const bool       isParallel = std::binary_search(m_Parallel.begin(), m_Parallel.end(), edge);
    std::vector<int> part;
    std::transform(path.begin() + (isParallel ? 1 : 0), path.end(), std::back_inserter(part), halfOf);
    if (part.size() > 1)
    {
      result.subdivided.push_back(part);
    }
  }
  return result;
}

PackedMap
ParallelEdges::Restored(PackedMap packed) const
{
  auto       paths = PathsOf(packed);
  const auto pathOf = [&](int edge) {
    const auto found = paths.find(edge);
    return found == paths.end() ? std::vector<int>{ 2 * edge } : found->second;
  };
  for (std::size_t j = 0; j < m_Parallel.size(); ++j)
  {
    const int        second = m_Edges + static_cast<int>(j);
    std::vector<int> path = pathOf(m_Parallel[j]);
    const auto       rest = pathOf(second);
    path.insert(path.end(), rest.begin(), rest.end());
    paths.erase(second);
    paths[m_Parallel[j]] = path;
  }
  packed.subdivided.clear();
  for (const auto & [edge, path] : paths)
  {
    packed.subdivided.push_back(path);
  }
  packed.graphNodes = m_Nodes;
  packed.graphEdges = m_Edges;
  return packed;
}
} // namespace shapeton
