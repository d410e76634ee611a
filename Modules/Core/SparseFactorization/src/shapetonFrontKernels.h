#ifndef shapetonFrontKernels_h
#define shapetonFrontKernels_h

#include "shapetonInstructionSets.h"

#include <cstddef>

namespace shapeton
{
/** Dense kernels of frontal matrices, real and complex, for each instruction set: see InstructionSets. Sums run over
 * one index in ascending order. */
namespace FrontKernels
{
/** Rows of a matrix are grouped into cache lines of this many doubles; the last group is padded. */
constexpr int rowGroup = 8;

inline constexpr int
PaddedRows(int rows)
{
  return (rows + rowGroup - 1) / rowGroup * rowGroup;
}

/** A real column-major matrix. */
struct Panel
{
  double *       data;
  std::ptrdiff_t stride; ///< from one column to the next
};

/** A complex column-major matrix: all real parts, then, at an offset of `plane` doubles, all imaginary parts. */
struct Block
{
  double *       data;
  std::ptrdiff_t stride; ///< from one column to the next
  std::ptrdiff_t plane;
};

/** A complex matrix with access to single elements. */
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
  /** Replaces the first `width` columns of a real symmetric front of `rows` rows, given by its lower triangle, by the
   * columns of L, and sets `signs` such that the front is L diag(signs) L^T. L is the Cholesky factor if all signs are
   * 1. The stride is at least PaddedRows(rows). Returns the first column whose pivot is 0 or not finite, or -1. */
  int (*Factor)(int rows, int width, const Panel & panel, double * signs);
  /** Subtracts A diag(signs) A^T from columns `begin` <= j < `end` of the lower triangle of the real C; A has `rows`
   * rows and `depth` columns. `begin` is a multiple of rowGroup. C and A are read up to PaddedRows(rows). */
  void (
    *SubtractSquare)(int rows, int begin, int end, int depth, const Panel & A, const double * signs, const Panel & C);
  /** Stores A B into the complex C: C has `rows` rows, a multiple of rowGroup, and `columns` columns; A has `depth`
   * columns. With `lowerOnly`, elements above the diagonal of C may or may not be computed. */
  void (*Multiply)(int              rows,
                   int              columns,
                   int              depth,
                   const Block &    A,
                   const Elements & B,
                   const Block &    C,
                   Store            store,
                   bool             lowerOnly);
  /** Replaces the leading n x n part of the complex P, whose padding is zero, by its inverse, without pivoting. `work`
   * has 2 PaddedRows(n) doubles. */
  void (*Invert)(int n, const Block & P, double * work);

  static const Set & Compiled(InstructionSets::Baseline);
  static const Set & Compiled(InstructionSets::Avx2);
  static const Set & Compiled(InstructionSets::Avx512);
};
} // namespace FrontKernels
} // namespace shapeton

#endif
