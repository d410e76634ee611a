#ifndef shapetonFrontKernels_h
#define shapetonFrontKernels_h

#include <cstddef>

namespace shapeton
{
/** Dense complex products for frontal matrices, compiled once for each instruction set. All sets do the same operations
 * in the same order, so they give the same bytes: a sum runs over one index in ascending order, nothing is fused. The
 * files of these kernels include no standard library, whose inline functions would be compiled for that CPU, too. */
namespace FrontKernels
{
/** Rows of a block come in groups of so many doubles, a cache line; the last group is padded. */
constexpr int rowGroup = 8;

inline constexpr int
PaddedRows(int rows)
{
  return (rows + rowGroup - 1) / rowGroup * rowGroup;
}

/** A complex matrix, column by column: all real parts, then, `plane` doubles further, all imaginary parts. */
struct Block
{
  double *       data;
  std::ptrdiff_t stride; ///< from one column to the next
  std::ptrdiff_t plane;
};

/** A complex matrix that is read element by element. */
struct Elements
{
  const double * data;
  std::ptrdiff_t rowStride;
  std::ptrdiff_t columnStride;
  std::ptrdiff_t plane;
};

enum class Store
{
  Assign,  ///< C = A B
  Negate,  ///< C = -A B
  Add,     ///< C = C + A B
  Subtract ///< C = C - A B
};

struct Set
{
  const char * name;
  /** Stores A B into C: C has `rows` rows, a multiple of rowGroup, and `columns` columns; A has `depth` columns. With
   * `lowerOnly` elements above the diagonal of C may or may not be computed. */
  void (*Multiply)(int              rows,
                   int              columns,
                   int              depth,
                   const Block &    A,
                   const Elements & B,
                   const Block &    C,
                   Store            store,
                   bool             lowerOnly);
  /** Replaces the leading n x n part of P, whose padding is zero, by its inverse, without pivoting. `work` holds
   * 2 PaddedRows(n) doubles. */
  void (*Invert)(int n, const Block & P, double * work);
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
} // namespace FrontKernels
} // namespace shapeton

#endif
