#include "shapetonOrderOfElimination.h"

#include <Eigen/OrderingMethods>
#include <metis.h>

#include <algorithm>
#include <csignal>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Below this size any order is sufficient. */
constexpr int fewVertices = 16;

struct Graph
{
  Graph(int numberOfVertices, const std::vector<std::array<int, 2>> & edges)
    : begin(numberOfVertices + 1, 0), neighbors(2 * edges.size())
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
      neighbors[next[a]++] = b;
      neighbors[next[b]++] = a;
    }
  }
  std::vector<idx_t> begin;
  std::vector<idx_t> neighbors;
};

void
RunMetis(Graph & graph, std::vector<idx_t> & order, std::vector<idx_t> & place)
{
  static std::mutex                 mutex; // std::rand() has one state for all threads
  const std::lock_guard<std::mutex> lock(mutex);
  idx_t                             options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  auto      vertices = static_cast<idx_t>(order.size());
  const int status =
    METIS_NodeND(&vertices, graph.begin.data(), graph.neighbors.data(), nullptr, options, order.data(), place.data());
  if (status == METIS_ERROR_MEMORY)
  {
    throw std::bad_alloc();
  }
  if (status == METIS_ERROR)
  {
    std::raise(SIGTERM); // METIS catches the signal and returns instead
  }
  if (status != METIS_OK)
  {
    throw std::runtime_error("METIS gave up on a graph of " + std::to_string(vertices) + " vertices");
  }
}

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

std::vector<int>
MinimumDegree(int numberOfVertices, const std::vector<std::array<int, 2>> & edges)
{
  // The lower triangle with the diagonal, as required by AMDOrdering; values are ignored.
  const auto                  elements = static_cast<Eigen::Index>(numberOfVertices + edges.size());
  Eigen::SparseMatrix<double> pattern(numberOfVertices, numberOfVertices);
  pattern.resizeNonZeros(elements);
  std::fill_n(pattern.valuePtr(), elements, 1.0);
  int * const begin = pattern.outerIndexPtr();
  begin[0] = 0;
  std::fill_n(begin + 1, numberOfVertices, 1);
  for (const auto & [a, b] : edges)
  {
    ++begin[std::min(a, b) + 1];
  }
  std::partial_sum(begin, begin + numberOfVertices + 1, begin);
  std::vector<int> next(begin, begin + numberOfVertices);
  for (int vertex = 0; vertex < numberOfVertices; ++vertex)
  {
    pattern.innerIndexPtr()[next[vertex]++] = vertex;
  }
  for (const auto & [a, b] : edges)
  {
    pattern.innerIndexPtr()[next[std::min(a, b)]++] = std::max(a, b);
  }
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), permutation);
  return { permutation.indices().data(), permutation.indices().data() + numberOfVertices };
}
} // namespace

std::vector<int>
OrderOfElimination(int numberOfVertices, const std::vector<std::array<int, 2>> & edges, EliminationOrder order)
{
  return order == EliminationOrder::MinimumDegree ? MinimumDegree(numberOfVertices, edges)
                                                  : NestedDissection(numberOfVertices, edges);
}
} // namespace shapeton
