#include "shapetonNestedDissection.h"

#include <metis.h>

#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Below this any order will do. */
constexpr int fewVertices = 16;

struct Graph
{
  Graph(int numberOfVertices, const std::vector<std::array<int, 2>> & edges)
    : begin(numberOfVertices + 1, 0), neighbours(2 * edges.size())
  {
    for (const auto & [a, b] : edges)
    {
      ++begin[a + 1];
      ++begin[b + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<idx_t> next(begin.begin(), begin.end() - 1);
    for (const auto & [a, b] : edges)
    {
      neighbours[next[a]++] = b;
      neighbours[next[b]++] = a;
    }
  }
  std::vector<idx_t> begin;
  std::vector<idx_t> neighbours;
};

void
RunMetis(Graph & graph, std::vector<idx_t> & order, std::vector<idx_t> & place)
{
  static std::mutex                 mutex; // std::rand() is one for all threads
  const std::lock_guard<std::mutex> lock(mutex);
  idx_t                             options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  auto      vertices = static_cast<idx_t>(order.size());
  const int status =
    METIS_NodeND(&vertices, graph.begin.data(), graph.neighbours.data(), nullptr, options, order.data(), place.data());
  if (status == METIS_ERROR_MEMORY)
  {
    throw std::bad_alloc();
  }
  if (status != METIS_OK)
  {
    throw std::logic_error("METIS refuses a graph of " + std::to_string(vertices) + " vertices");
  }
}
} // namespace

std::vector<int>
NestedDissection(int numberOfVertices, const std::vector<std::array<int, 2>> & edges)
{
  std::vector<idx_t> order(numberOfVertices);
  std::iota(order.begin(), order.end(), 0);
  if (numberOfVertices > fewVertices && !edges.empty())
  {
    Graph              graph(numberOfVertices, edges);
    std::vector<idx_t> place(numberOfVertices);
    RunMetis(graph, order, place);
  }
  return { order.begin(), order.end() };
}
} // namespace shapeton
