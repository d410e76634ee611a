#include "shapetonSelectedInversion.h"

#include "shapetonInversionSchedule.h"
#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"

#include <algorithm>

namespace shapeton
{
struct SelectedInversion::Layout
{
  Layout(int numberOfVertices, const std::vector<std::array<int, 2>> & edges)
    : supernodes(numberOfVertices, edges), factor(supernodes), tasks(supernodes)
  {}
  Supernodes   supernodes;
  FactorLayout factor;
  SubtreeTasks tasks;
};

namespace
{
void
CheckEdges(int numberOfVertices, std::vector<std::array<int, 2>> edges)
{
  if (numberOfVertices < 1)
  {
    throw InputError("a matrix needs at least one row");
  }
  for (auto & [a, b] : edges)
  {
    if (a < 0 || b < 0 || a >= numberOfVertices || b >= numberOfVertices || a == b)
    {
      throw InputError("edge " + std::to_string(a) + ", " + std::to_string(b) + " is not a pair of different rows of " +
                       std::to_string(numberOfVertices));
    }
    std::tie(a, b) = std::minmax({ a, b });
  }
  std::sort(edges.begin(), edges.end());
  const auto twin = std::adjacent_find(edges.begin(), edges.end());
  if (twin != edges.end())
  {
    throw InputError("edge " + std::to_string((*twin)[0]) + ", " + std::to_string((*twin)[1]) +
                     " occurs twice; add the elements up");
  }
}

void
CheckFinite(int matrix, const SymmetricElements & inverse)
{
  if (!inverse.diagonal.allFinite() || !inverse.offDiagonal.allFinite())
  {
    throw InputError("matrix " + std::to_string(matrix) +
                     " cannot be inverted without pivoting: a pivot is 0, or an element not finite");
  }
}
} // namespace

SelectedInversion::SelectedInversion(int numberOfVertices, std::vector<std::array<int, 2>> edges)
  : m_NumberOfVertices(std::max(numberOfVertices, 0)), m_NumberOfEdges(edges.size())
{
  CheckEdges(numberOfVertices, edges);
  m_Layout = std::make_unique<Layout>(numberOfVertices, edges);
}

SelectedInversion::~SelectedInversion() = default;
SelectedInversion::SelectedInversion(SelectedInversion &&) noexcept = default;
SelectedInversion &
SelectedInversion::operator=(SelectedInversion &&) noexcept = default;

void
SelectedInversion::CheckSizes(const SymmetricElements & matrix) const
{
  if (static_cast<std::size_t>(matrix.diagonal.size()) != m_NumberOfVertices ||
      static_cast<std::size_t>(matrix.offDiagonal.size()) != m_NumberOfEdges)
  {
    throw InputError("a matrix of " + std::to_string(matrix.diagonal.size()) + " diagonal and " +
                     std::to_string(matrix.offDiagonal.size()) + " other elements does not fit a pattern of " +
                     std::to_string(m_NumberOfVertices) + " and " + std::to_string(m_NumberOfEdges));
  }
}

SymmetricElements
SelectedInversion::Invert(const SymmetricElements & matrix) const
{
  SymmetricElements inverse;
  this->InvertAll(
    1, [&](int) { return matrix; }, [&](int, const SymmetricElements & elements) { inverse = elements; });
  return inverse;
}

void
SelectedInversion::InvertAll(int                                                         number,
                             const std::function<SymmetricElements(int)> &               matrixOf,
                             const std::function<void(int, const SymmetricElements &)> & take,
                             int                                                         atOnce) const
{
  const InversionSchedule::MatrixOf checkedMatrixOf = [&](int matrix) {
    SymmetricElements elements = matrixOf(matrix);
    this->CheckSizes(elements);
    return elements;
  };
  const InversionSchedule::Take checkedTake = [&](int matrix, const SymmetricElements & inverse) {
    CheckFinite(matrix, inverse);
    take(matrix, inverse);
  };
  InversionSchedule schedule(
    m_Layout->supernodes, m_Layout->factor, m_Layout->tasks, number, std::max(1, atOnce), checkedMatrixOf, checkedTake);
  const std::size_t pieces = (m_Layout->tasks.roots.size() + 1) * std::max(1, atOnce);
  ParallelWorkers(static_cast<unsigned int>(std::min<std::size_t>(pieces, NumberOfThreads())),
                  [&](unsigned int) { schedule.Work(); });
}

int
SelectedInversion::NumberOfSupernodes() const
{
  return m_Layout->supernodes.Number();
}

std::size_t
SelectedInversion::FactorElements() const
{
  return m_Layout->factor.begin.back() / 2;
}

double
SelectedInversion::Products() const
{
  return 2.0 * m_Layout->tasks.products;
}
} // namespace shapeton
