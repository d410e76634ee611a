#ifndef shapetonPanelKernels_h
#define shapetonPanelKernels_h

#include <cstddef>

namespace shapeton
{
/** Dense real kernels of Cholesky's elimination, compiled once for each instruction set. All sets do the same
 * operations in the same order, so they give the same bytes: a sum runs over one index in ascending order, nothing is
 * fused. The files of these kernels include no standard library, whose inline functions would be compiled for that CPU,
 * too. */
namespace PanelKernels
{
/** Rows of a panel come in groups of so many doubles, a cache line; the last group is padded. */
constexpr int rowGroup = 8;

inline constexpr std::ptrdiff_t
PaddedRows(int rows)
{
  return (rows + rowGroup - 1) / rowGroup * rowGroup;
}

/** A matrix, column by column. */
struct Panel
{
  double *       data;
  std::ptrdiff_t stride; ///< from one column to the next
};

struct Set
{
  const char * name;
  /** Replaces the first `width` columns of a symmetric positive definite front of `rows` rows, of which the lower
   * triangle is given, by those of its Cholesky factor. The stride is PaddedRows(rows) or more. Returns the first
   * column whose pivot is not positive, or -1. */
  int (*Factor)(int rows, int width, const Panel & panel);
  /** Subtracts from the lower triangle of C, columns `begin` <= j < `end`, the elements of A A^T: A has `rows` rows and
   * `depth` columns. `begin` is a multiple of rowGroup. C and A are read up to PaddedRows(rows). */
  void (*SubtractSquare)(int rows, int begin, int end, int depth, const Panel & A, const Panel & C);
};

const Set &
GetBaseline();
const Set &
GetAvx2();
const Set &
GetAvx512();
/** The fastest that this CPU runs. */
const Set &
GetBest();
} // namespace PanelKernels
} // namespace shapeton

#endif
