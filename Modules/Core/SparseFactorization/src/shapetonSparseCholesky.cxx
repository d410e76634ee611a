#include "shapetonSparseCholesky.h"

#include "shapetonAlignedBuffer.h"
#include "shapetonExceptions.h"
#include "shapetonFrontKernels.h"
#include "shapetonKernelSets.h"
#include "shapetonParallelFor.h"
#include "shapetonSymbolicParts.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace shapeton
{
using FrontKernels::PaddedRows;
using FrontKernels::Panel;

namespace
{
/** Minimum number of rows of an update that is computed by several threads. */
constexpr int rowsWorthSharing = 512;

void
Clear(double * data, std::size_t number)
{
  std::memset(data, 0, number * sizeof(double));
}
} // namespace

class SparseCholesky::Implementation
{
public:
  explicit Implementation(SymbolicFactorization symbolic);

  bool
  Factorize(const Eigen::Ref<const Eigen::VectorXd> & diagonal,
            const Eigen::Ref<const Eigen::VectorXd> & offDiagonal,
            const Progress &                          progress);
  void
  SolveInPlace(Eigen::Ref<Eigen::VectorXd> b) const;
  bool
  HasFactor() const
  {
    return m_HasFactor;
  }
  int
  NegativeEigenvalues() const
  {
    return static_cast<int>(std::count(m_Signs.begin(), m_Signs.end(), -1.0));
  }
  const SymbolicFactorization &
  Symbolic() const
  {
    return m_Symbolic;
  }

private:
  int
  Rows(int s) const
  {
    return m_Supernodes.Width(s) + m_Supernodes.NumberOfRows(s);
  }
  bool
  EliminateSubtrees(const Progress & progress);
  bool
  EliminateTrunk(const Progress & progress);
  bool
  Eliminate(int s, bool shared, AlignedBuffer & workspace);
  void
  Assemble(int s, const Panel & front, const Panel & update) const;
  void
  AddChild(int child, int s, const Panel & front, const Panel & update) const;
  void
  SubtractPanel(int s, bool shared, const Panel & front, const Panel & update) const;
  void
  Keep(int s, const Panel & front);
  void
  SolveForward(double * x) const;
  void
  SolveBackward(double * x) const;

  SymbolicFactorization      m_Symbolic;
  const Supernodes &         m_Supernodes;
  const FrontKernels::Set &  m_Kernels;
  std::vector<std::size_t>   m_Begin; ///< start of the panel of each supernode, Rows x Width without padding
  std::size_t                m_LargestPanel{ 0 };
  AlignedBuffer              m_Factor;
  std::vector<double>        m_Signs; ///< signs of the pivots
  std::vector<AlignedBuffer> m_Updates;
  bool                       m_HasFactor{ false };
  const double *             m_Diagonal{ nullptr };
  const double *             m_OffDiagonal{ nullptr };
};

SparseCholesky::Implementation::Implementation(SymbolicFactorization symbolic)
  : m_Symbolic(std::move(symbolic))
  , m_Supernodes(m_Symbolic.GetParts().supernodes)
  , m_Kernels(BestKernels<FrontKernels::Set>())
  , m_Begin(1, 0)
  , m_Signs(m_Supernodes.order.size())
  , m_Updates(m_Supernodes.Number())
{
  for (int s = 0; s < m_Supernodes.Number(); ++s)
  {
    const std::size_t width = m_Supernodes.Width(s);
    m_Begin.push_back(m_Begin.back() + width * this->Rows(s));
    m_LargestPanel = std::max(m_LargestPanel, width * PaddedRows(this->Rows(s)) + FrontKernels::rowGroup);
  }
  m_Factor = AlignedBuffer(m_Begin.back());
}

/** Adds the update of a child to the columns of the front or of its update. */
void
SparseCholesky::Implementation::AddChild(int child, int s, const Panel & front, const Panel & update) const
{
  const int            width = m_Supernodes.Width(s);
  const int            rows = m_Supernodes.NumberOfRows(child);
  const int *          place = m_Supernodes.placeInParent.data() + m_Supernodes.rowBegin[child];
  const std::ptrdiff_t stride = PaddedRows(rows);
  for (int j = 0; j < rows; ++j)
  {
    const double * const from = m_Updates[child].Data() + j * stride;
    if (place[j] < width)
    {
      double * const to = front.data + place[j] * front.stride;
      for (int i = j; i < rows; ++i)
      {
        to[place[i]] += from[i];
      }
      continue;
    }
    double * const to = update.data + (place[j] - width) * update.stride - width;
    for (int i = j; i < rows; ++i)
    {
      to[place[i]] += from[i];
    }
  }
}

void
SparseCholesky::Implementation::Assemble(int s, const Panel & front, const Panel & update) const
{
  for (std::size_t e = m_Supernodes.entryBegin[s]; e < m_Supernodes.entryBegin[s + 1]; ++e)
  {
    const auto & entry = m_Supernodes.entries[e];
    front.data[entry.column * front.stride + entry.row] +=
      entry.source < 0 ? m_Diagonal[-1 - entry.source] : m_OffDiagonal[entry.source];
  }
  for (int child = m_Supernodes.lastChild[s]; child != -1; child = m_Supernodes.sibling[child])
  {
    this->AddChild(child, s, front, update);
  }
}

void
SparseCholesky::Implementation::SubtractPanel(int s, bool shared, const Panel & front, const Panel & update) const
{
  const int            width = m_Supernodes.Width(s);
  const int            rows = m_Supernodes.NumberOfRows(s);
  const Panel          below{ front.data + width, front.stride };
  const double * const signs = m_Signs.data() + m_Supernodes.firstColumn[s];
  if (!shared || rows < rowsWorthSharing)
  {
    m_Kernels.SubtractSquare(rows, 0, rows, width, below, signs, update);
    return;
  }
  constexpr int strip = 64;
  ParallelFor((rows + strip - 1) / strip, [&](std::size_t i) {
    const int begin = static_cast<int>(i) * strip;
    m_Kernels.SubtractSquare(rows, begin, std::min(begin + strip, rows), width, below, signs, update);
  });
}

void
SparseCholesky::Implementation::Keep(int s, const Panel & front)
{
  const int rows = this->Rows(s);
  for (int j = 0; j < m_Supernodes.Width(s); ++j)
  {
    const double * const from = front.data + j * front.stride;
    std::copy(from, from + rows, m_Factor.Data() + m_Begin[s] + static_cast<std::size_t>(j) * rows);
  }
}

bool
SparseCholesky::Implementation::Eliminate(int s, bool shared, AlignedBuffer & workspace)
{
  const int   width = m_Supernodes.Width(s);
  const int   rows = m_Supernodes.NumberOfRows(s);
  const Panel front{ workspace.Data(), PaddedRows(width + rows) };
  Clear(front.data, width * front.stride + FrontKernels::rowGroup);
  const Panel update{ nullptr, PaddedRows(rows) };
  if (rows > 0)
  {
    m_Updates[s] = AlignedBuffer(rows * update.stride);
    Clear(m_Updates[s].Data(), rows * update.stride);
  }
  const Panel target{ m_Updates[s].Data(), update.stride };
  this->Assemble(s, front, target);
  for (int child = m_Supernodes.lastChild[s]; child != -1; child = m_Supernodes.sibling[child])
  {
    m_Updates[child].Free();
  }
  if (m_Kernels.Factor(width + rows, width, front, m_Signs.data() + m_Supernodes.firstColumn[s]) >= 0)
  {
    return false;
  }
  this->SubtractPanel(s, shared, front, target);
  this->Keep(s, front);
  return true;
}

/** Factorizes the subtrees, one thread per subtree. */
bool
SparseCholesky::Implementation::EliminateSubtrees(const Progress & progress)
{
  const SubtreeTasks &       tasks = m_Symbolic.GetParts().tasks;
  std::atomic<bool>          isRegular{ true };
  std::vector<AlignedBuffer> workspaces(NumberOfThreads());
  ParallelForWorkers(
    tasks.roots.size(),
    [&](std::size_t task, unsigned int worker) {
      if (!workspaces[worker])
      {
        workspaces[worker] = AlignedBuffer(m_LargestPanel);
      }
      const int root = tasks.roots[task];
      for (int s = m_Supernodes.firstDescendant[root]; s <= root && isRegular; ++s)
      {
        if (!this->Eliminate(s, false, workspaces[worker]))
        {
          isRegular = false;
        }
      }
    },
    progress);
  return isRegular;
}

/** Factorizes the trunk front by front, with all threads. */
bool
SparseCholesky::Implementation::EliminateTrunk(const Progress & progress)
{
  const std::vector<int> & trunk = m_Symbolic.GetParts().tasks.trunk;
  AlignedBuffer            workspace(m_LargestPanel);
  for (std::size_t i = 0; i < trunk.size(); ++i)
  {
    if (!this->Eliminate(trunk[i], true, workspace))
    {
      return false;
    }
    progress((i + 1.0) / static_cast<double>(trunk.size()));
  }
  return true;
}

bool
SparseCholesky::Implementation::Factorize(const Eigen::Ref<const Eigen::VectorXd> & diagonal,
                                          const Eigen::Ref<const Eigen::VectorXd> & offDiagonal,
                                          const Progress &                          progress)
{
  if (diagonal.size() != m_Symbolic.NumberOfVertices() || offDiagonal.size() != m_Symbolic.NumberOfEdges())
  {
    throw InputError("a matrix of " + std::to_string(diagonal.size()) + " diagonal and " +
                     std::to_string(offDiagonal.size()) + " other elements does not fit a pattern of " +
                     std::to_string(m_Symbolic.NumberOfVertices()) + " and " +
                     std::to_string(m_Symbolic.NumberOfEdges()));
  }
  m_Diagonal = diagonal.data();
  m_OffDiagonal = offDiagonal.data();
  m_HasFactor = false;
  m_HasFactor =
    this->EliminateSubtrees(progress.Part("", 0.0, 0.5)) && this->EliminateTrunk(progress.Part("", 0.5, 1.0));
  if (!m_HasFactor)
  {
    m_Updates = std::vector<AlignedBuffer>(m_Supernodes.Number());
  }
  return m_HasFactor && this->NegativeEigenvalues() == 0;
}

void
SparseCholesky::Implementation::SolveForward(double * x) const
{
  for (int s = 0; s < m_Supernodes.Number(); ++s)
  {
    const int         width = m_Supernodes.Width(s);
    const int         rows = m_Supernodes.NumberOfRows(s);
    const int * const below = m_Supernodes.rows.data() + m_Supernodes.rowBegin[s];
    const double *    column = m_Factor.Data() + m_Begin[s];
    double * const    own = x + m_Supernodes.firstColumn[s];
    for (int j = 0; j < width; ++j, column += width + rows)
    {
      const double value = own[j] /= column[j];
      for (int i = j + 1; i < width; ++i)
      {
        own[i] -= column[i] * value;
      }
      for (int i = 0; i < rows; ++i)
      {
        x[below[i]] -= column[width + i] * value;
      }
    }
  }
}

void
SparseCholesky::Implementation::SolveBackward(double * x) const
{
  for (int s = m_Supernodes.Number() - 1; s >= 0; --s)
  {
    const int         width = m_Supernodes.Width(s);
    const int         rows = m_Supernodes.NumberOfRows(s);
    const int * const below = m_Supernodes.rows.data() + m_Supernodes.rowBegin[s];
    double * const    own = x + m_Supernodes.firstColumn[s];
    for (int j = width - 1; j >= 0; --j)
    {
      const double * const column = m_Factor.Data() + m_Begin[s] + static_cast<std::size_t>(j) * (width + rows);
      double               value = m_Signs[m_Supernodes.firstColumn[s] + j] * own[j];
      for (int i = 0; i < rows; ++i)
      {
        value -= column[width + i] * x[below[i]];
      }
      for (int i = width - 1; i > j; --i)
      {
        value -= column[i] * own[i];
      }
      own[j] = value / column[j];
    }
  }
}

void
SparseCholesky::Implementation::SolveInPlace(Eigen::Ref<Eigen::VectorXd> b) const
{
  const std::vector<int> & order = m_Supernodes.order;
  std::vector<double>      x(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    x[i] = b[order[i]];
  }
  this->SolveForward(x.data());
  this->SolveBackward(x.data());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    b[order[i]] = x[i];
  }
}

SparseCholesky::SparseCholesky(SymbolicFactorization symbolic)
  : m_Implementation(std::make_unique<Implementation>(std::move(symbolic)))
{}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky &&) noexcept = default;
SparseCholesky &
SparseCholesky::operator=(SparseCholesky &&) noexcept = default;

bool
SparseCholesky::Factorize(const Eigen::Ref<const Eigen::VectorXd> & diagonal,
                          const Eigen::Ref<const Eigen::VectorXd> & offDiagonal,
                          const Progress &                          progress)
{
  return m_Implementation->Factorize(diagonal, offDiagonal, progress);
}

bool
SparseCholesky::Factorize(const Eigen::SparseMatrix<double> & matrix, const Progress & progress)
{
  std::vector<double> offDiagonal;
  offDiagonal.reserve(m_Implementation->Symbolic().NumberOfEdges());
  for (int column = 0; column < matrix.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it)
    {
      if (it.row() > column)
      {
        offDiagonal.push_back(it.value());
      }
    }
  }
  return this->Factorize(
    matrix.diagonal(),
    Eigen::Map<const Eigen::VectorXd>(offDiagonal.data(), static_cast<Eigen::Index>(offDiagonal.size())),
    progress);
}

bool
SparseCholesky::HasFactor() const
{
  return m_Implementation->HasFactor();
}

int
SparseCholesky::NegativeEigenvalues() const
{
  return m_Implementation->NegativeEigenvalues();
}

void
SparseCholesky::SolveInPlace(Eigen::Ref<Eigen::MatrixXd> b, const Progress & progress) const
{
  ParallelFor(
    static_cast<std::size_t>(b.cols()),
    [&](std::size_t column) { m_Implementation->SolveInPlace(b.col(static_cast<Eigen::Index>(column))); },
    progress);
}

bool
SolvePositiveDefinite(const Eigen::SparseMatrix<double> & A, Eigen::Ref<Eigen::MatrixXd> b, const Progress & progress)
{
  SparseCholesky solver(SymbolicFactorization(A, EliminationOrder::MinimumDegree));
  progress(0.5);
  const bool isPositive = solver.Factorize(A, progress.Part("", 0.5, 0.9));
  if (isPositive)
  {
    solver.SolveInPlace(b, progress.Part("", 0.9, 1.0));
  }
  return isPositive;
}
} // namespace shapeton
