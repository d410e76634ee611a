// Compiled once per instruction set: see shapetonInstructionSets.h. Sums are computed in tiles of C that fill the
// registers.
#include "shapetonFrontKernels.h"

namespace shapeton
{
namespace FrontKernels
{
namespace
{
constexpr int lanes = SHAPETON_VECTOR_BYTES / 8; // double numbers of a vector
/** Tile size in vectors x columns: there are 16 registers, 32 with AVX-512. */
constexpr int realVectors = SHAPETON_VECTOR_BYTES > 16 ? 3 : 2;
constexpr int realColumns = SHAPETON_VECTOR_BYTES > 32 ? 8 : 4;
constexpr int complexVectors = 2;
constexpr int complexColumns = SHAPETON_VECTOR_BYTES > 32 ? 4 : 2;
/** Number of columns of a real front that are eliminated together. */
constexpr int blockWidth = 8;
/** Depth of a partial sum: a tile of A then stays in the first-level cache. */
constexpr int depthBlock = 128;

// Aligned as doubles, and allowed to alias them.
using Vector = double __attribute__((vector_size(SHAPETON_VECTOR_BYTES), aligned(8), may_alias));

#define SHAPETON_INLINE __attribute__((always_inline)) inline

SHAPETON_INLINE Vector
Load(const double * from)
{
  return *reinterpret_cast<const Vector *>(from);
}

SHAPETON_INLINE void
Save(Vector value, double * to)
{
  *reinterpret_cast<Vector *>(to) = value;
}

// ---- real

/** C -= A diag(signs) B^T for a tile; `b` points to its rows of B. */
template <int VVectors, int VColumns>
SHAPETON_INLINE void
SubtractTile(int            depth,
             const double * a,
             const double * signs,
             const double * b,
             std::ptrdiff_t stride,
             const Panel &  C)
{
  Vector sum[VColumns][VVectors] = {};
  for (int k = 0; k < depth; ++k)
  {
    Vector column[VVectors];
    for (int v = 0; v < VVectors; ++v)
    {
      column[v] = Load(a + v * lanes) * signs[k];
    }
    for (int c = 0; c < VColumns; ++c)
    {
      for (int v = 0; v < VVectors; ++v)
      {
        sum[c][v] += column[v] * b[c];
      }
    }
    a += stride;
    b += stride;
  }
  for (int c = 0; c < VColumns; ++c)
  {
    for (int v = 0; v < VVectors; ++v)
    {
      double * const to = C.data + c * C.stride + v * lanes;
      Save(Load(to) - sum[c][v], to);
    }
  }
}

template <int VVectors>
SHAPETON_INLINE void
SubtractRows(int            columns,
             int            depth,
             const double * a,
             const double * signs,
             const double * b,
             std::ptrdiff_t stride,
             Panel          C)
{
  int column = 0;
  for (; column + realColumns <= columns; column += realColumns)
  {
    SubtractTile<VVectors, realColumns>(depth, a, signs, b, stride, C);
    b += realColumns;
    C.data += realColumns * C.stride;
  }
  for (; column < columns; ++column)
  {
    SubtractTile<VVectors, 1>(depth, a, signs, b, stride, C);
    ++b;
    C.data += C.stride;
  }
}

SHAPETON_INLINE int
Smaller(int a, int b)
{
  return a < b ? a : b;
}

void
SubtractSquare(int rows, int begin, int end, int depth, const Panel & A, const double * signs, const Panel & C)
{
  constexpr int  tileRows = realVectors * lanes;
  double * const first = C.data + begin * C.stride;
  int            row = begin;
  for (; row + tileRows <= rows; row += tileRows)
  {
    SubtractRows<realVectors>(Smaller(row + tileRows, end) - begin,
                              depth,
                              A.data + row,
                              signs,
                              A.data + begin,
                              A.stride,
                              { first + row, C.stride });
  }
  for (; row < rows; row += lanes)
  {
    SubtractRows<1>(Smaller(Smaller(row + lanes, end), rows) - begin,
                    depth,
                    A.data + row,
                    signs,
                    A.data + begin,
                    A.stride,
                    { first + row, C.stride });
  }
}

/** Eliminates the columns [begin, end) of a panel; the contributions of earlier columns are already subtracted. */
SHAPETON_INLINE int
FactorBlock(int rows, int begin, int end, const Panel & panel, double * signs)
{
  for (int j = begin; j < end; ++j)
  {
    double * const column = panel.data + j * panel.stride;
    const double   pivot = column[j];
    const double   size = __builtin_fabs(pivot);
    if (!(size > 0.0 && size < 1e300))
    {
      return j;
    }
    const double root = __builtin_sqrt(size);
    signs[j] = pivot > 0.0 ? 1.0 : -1.0;
    const double inverse = signs[j] / root;
    for (int i = begin; i < rows; i += lanes)
    {
      Save(Load(column + i) * inverse, column + i);
    }
    column[j] = root;
    for (int c = j + 1; c < end; ++c)
    {
      double * const next = panel.data + c * panel.stride;
      const double   factor = signs[j] * column[c];
      for (int i = begin; i < rows; i += lanes)
      {
        Save(Load(next + i) - Load(column + i) * factor, next + i);
      }
    }
  }
  return -1;
}

int
Factor(int rows, int width, const Panel & panel, double * signs)
{
  for (int begin = 0; begin < width; begin += blockWidth)
  {
    const int end = Smaller(begin + blockWidth, width);
    if (begin > 0)
    {
      SubtractSquare(rows, begin, end, begin, panel, signs, panel);
    }
    const int failure = FactorBlock(rows, begin, end, panel, signs);
    if (failure >= 0)
    {
      return failure;
    }
  }
  return -1;
}

// ---- complex

SHAPETON_INLINE void
StoreVector(Vector value, double * to, Store store)
{
  if (store == Store::Subtract)
  {
    value = Load(to) - value;
  }
  else if (store == Store::Add)
  {
    value = Load(to) + value;
  }
  else if (store == Store::Negate)
  {
    value = -value;
  }
  Save(value, to);
}

template <int VVectors, int VColumns>
SHAPETON_INLINE void
MultiplyTile(int depth, Block A, Elements B, Block C, Store store)
{
  Vector re[VColumns][VVectors] = {};
  Vector im[VColumns][VVectors] = {};
  for (int k = 0; k < depth; ++k)
  {
    Vector aRe[VVectors];
    Vector aIm[VVectors];
    for (int v = 0; v < VVectors; ++v)
    {
      aRe[v] = Load(A.data + v * lanes);
      aIm[v] = Load(A.data + v * lanes + A.plane);
    }
    for (int c = 0; c < VColumns; ++c)
    {
      const double bRe = B.data[c * B.columnStride];
      const double bIm = B.data[c * B.columnStride + B.plane];
      for (int v = 0; v < VVectors; ++v)
      {
        re[c][v] += aRe[v] * bRe;
        im[c][v] += aRe[v] * bIm;
        re[c][v] -= aIm[v] * bIm;
        im[c][v] += aIm[v] * bRe;
      }
    }
    A.data += A.stride;
    B.data += B.rowStride;
  }
  for (int c = 0; c < VColumns; ++c)
  {
    for (int v = 0; v < VVectors; ++v)
    {
      double * const to = C.data + c * C.stride + v * lanes;
      StoreVector(re[c][v], to, store);
      StoreVector(im[c][v], to + C.plane, store);
    }
  }
}

template <int VVectors>
SHAPETON_INLINE void
MultiplyRows(int columns, int depth, const Block & A, Elements B, Block C, Store store)
{
  int column = 0;
  for (; column + complexColumns <= columns; column += complexColumns)
  {
    MultiplyTile<VVectors, complexColumns>(depth, A, B, C, store);
    B.data += complexColumns * B.columnStride;
    C.data += complexColumns * C.stride;
  }
  for (; column < columns; ++column)
  {
    MultiplyTile<VVectors, 1>(depth, A, B, C, store);
    B.data += B.columnStride;
    C.data += C.stride;
  }
}

/** Number of columns of a lower triangle in rows below `end`. */
SHAPETON_INLINE int
ColumnsOfRows(int end, int columns, bool lowerOnly)
{
  return lowerOnly && end < columns ? end : columns;
}

SHAPETON_INLINE void
MultiplyDepth(int              rows,
              int              columns,
              int              depth,
              const Block &    A,
              const Elements & B,
              const Block &    C,
              Store            store,
              bool             lowerOnly)
{
  constexpr int tileRows = complexVectors * lanes;
  int           row = 0;
  for (; row + tileRows <= rows; row += tileRows)
  {
    MultiplyRows<complexVectors>(ColumnsOfRows(row + tileRows, columns, lowerOnly),
                                 depth,
                                 { A.data + row, A.stride, A.plane },
                                 B,
                                 { C.data + row, C.stride, C.plane },
                                 store);
  }
  for (; row < rows; row += lanes)
  {
    MultiplyRows<1>(ColumnsOfRows(row + lanes, columns, lowerOnly),
                    depth,
                    { A.data + row, A.stride, A.plane },
                    B,
                    { C.data + row, C.stride, C.plane },
                    store);
  }
}

void
Multiply(int              rows,
         int              columns,
         int              depth,
         const Block &    A,
         const Elements & B,
         const Block &    C,
         Store            store,
         bool             lowerOnly)
{
  if (depth <= depthBlock)
  {
    MultiplyDepth(rows, columns, depth, A, B, C, store, lowerOnly);
    return;
  }
  const Store next = store == Store::Assign || store == Store::Add ? Store::Add : Store::Subtract;
  for (int k = 0; k < depth; k += depthBlock)
  {
    const int part = depth - k < depthBlock ? depth - k : depthBlock;
    MultiplyDepth(rows,
                  columns,
                  part,
                  { A.data + k * A.stride, A.stride, A.plane },
                  { B.data + k * B.rowStride, B.rowStride, B.columnStride, B.plane },
                  C,
                  k == 0 ? store : next,
                  lowerOnly);
  }
}

/** Updates column j in a Gauss-Jordan step with the scaled element (re, im) of the pivot row: P_j -= factor v. */
SHAPETON_INLINE void
SubtractMultiple(int padded, const double * v, double re, double im, double * column, std::ptrdiff_t plane)
{
  for (int i = 0; i < padded; i += lanes)
  {
    const Vector vRe = Load(v + i);
    const Vector vIm = Load(v + padded + i);
    Save(Load(column + i) - vRe * re + vIm * im, column + i);
    Save(Load(column + plane + i) - vRe * im - vIm * re, column + plane + i);
  }
}

void
Invert(int n, const Block & P, double * work)
{
  const int padded = PaddedRows(n);
  for (int k = 0; k < n; ++k)
  {
    double * const pivotColumn = P.data + k * P.stride;
    for (int i = 0; i < padded; ++i)
    {
      work[i] = pivotColumn[i];
      work[padded + i] = pivotColumn[P.plane + i];
      pivotColumn[i] = 0.0;
      pivotColumn[P.plane + i] = 0.0;
    }
    const double square = work[k] * work[k] + work[padded + k] * work[padded + k];
    const double re = work[k] / square;
    const double im = -work[padded + k] / square;
    work[k] = 0.0;
    work[padded + k] = 0.0;
    pivotColumn[k] = 1.0;
    for (int j = 0; j < n; ++j)
    {
      double * const column = P.data + j * P.stride;
      const double   a = column[k];
      const double   b = column[P.plane + k];
      const double   scaledRe = a * re - b * im;
      const double   scaledIm = a * im + b * re;
      SubtractMultiple(padded, work, scaledRe, scaledIm, column, P.plane);
      column[k] = scaledRe;
      column[P.plane + k] = scaledIm;
    }
  }
}

constexpr Set kernels{ SHAPETON_STRING(SHAPETON_INSTRUCTION_SET), Factor, SubtractSquare, Multiply, Invert };
} // namespace

const Set &
Set::Compiled(InstructionSets::SHAPETON_INSTRUCTION_SET)
{
  return kernels;
}
} // namespace FrontKernels
} // namespace shapeton
