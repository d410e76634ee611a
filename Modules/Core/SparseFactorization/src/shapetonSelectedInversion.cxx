#include "shapetonSelectedInversion.h"

#include "shapetonExceptions.h"
#include "shapetonInversionSchedule.h"
#include "shapetonParallelFor.h"
#include "shapetonSymbolicParts.h"

#include <algorithm>

namespace shapeton
{
namespace
{
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

SelectedInversion::SelectedInversion(SymbolicFactorization symbolic)
  : m_Symbolic(std::move(symbolic)), m_Layout(std::make_unique<FactorLayout>(m_Symbolic.GetParts().supernodes))
{}

SelectedInversion::~SelectedInversion() = default;
SelectedInversion::SelectedInversion(SelectedInversion &&) noexcept = default;
SelectedInversion &
SelectedInversion::operator=(SelectedInversion &&) noexcept = default;

void
SelectedInversion::CheckSizes(const SymmetricElements & matrix) const
{
  if (matrix.diagonal.size() != m_Symbolic.NumberOfVertices() ||
      matrix.offDiagonal.size() != m_Symbolic.NumberOfEdges())
  {
    throw InputError("a matrix of " + std::to_string(matrix.diagonal.size()) + " diagonal and " +
                     std::to_string(matrix.offDiagonal.size()) + " other elements does not fit a pattern of " +
                     std::to_string(m_Symbolic.NumberOfVertices()) + " and " +
                     std::to_string(m_Symbolic.NumberOfEdges()));
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
                             int                                                         atOnce,
                             const Progress &                                            progress) const
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
  const auto &      parts = m_Symbolic.GetParts();
  InversionSchedule schedule(
    parts.supernodes, *m_Layout, parts.tasks, number, std::max(1, atOnce), checkedMatrixOf, checkedTake, progress);
  const std::size_t pieces = (parts.tasks.roots.size() + 1) * std::max(1, atOnce);
  ParallelWorkers(static_cast<unsigned int>(std::min<std::size_t>(pieces, NumberOfThreads())),
                  [&](unsigned int) { schedule.Work(); });
  progress(1.0);
}
} // namespace shapeton
