// The body of the kernels of fronts, compiled once for each instruction set: SHAPETON_LANES doubles to a vector, tiles
// of SHAPETON_TILE_VECTORS vectors x SHAPETON_TILE_COLUMNS columns, which fill the registers. No include guard and no
// standard library: see shapetonFrontKernels.h.
#include "shapetonFrontKernels.h"

namespace shapeton
{
namespace FrontKernels
{
namespace
{
constexpr int lanes = SHAPETON_LANES;
/** So much of a sum at a time: a tile of A then stays in the first-level cache. */
constexpr int depthBlock = 128;

// Aligned as doubles, and allowed to lie over them.
using Vector = double __attribute__((vector_size(8 * SHAPETON_LANES), aligned(8), may_alias));

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
  for (; column + SHAPETON_TILE_COLUMNS <= columns; column += SHAPETON_TILE_COLUMNS)
  {
    MultiplyTile<VVectors, SHAPETON_TILE_COLUMNS>(depth, A, B, C, store);
    B.data += SHAPETON_TILE_COLUMNS * B.columnStride;
    C.data += SHAPETON_TILE_COLUMNS * C.stride;
  }
  for (; column < columns; ++column)
  {
    MultiplyTile<VVectors, 1>(depth, A, B, C, store);
    B.data += B.columnStride;
    C.data += C.stride;
  }
}

/** The columns of a lower triangle that rows up to `end` meet. */
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
  constexpr int tileRows = SHAPETON_TILE_VECTORS * lanes;
  int           row = 0;
  for (; row + tileRows <= rows; row += tileRows)
  {
    MultiplyRows<SHAPETON_TILE_VECTORS>(ColumnsOfRows(row + tileRows, columns, lowerOnly),
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

/** Column j of the Gauss-Jordan step with the scaled element (re, im) of the pivot's row: P_j -= factor v. */
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

const Set kernels{ SHAPETON_NAME, Multiply, Invert };
} // namespace
} // namespace FrontKernels
} // namespace shapeton
