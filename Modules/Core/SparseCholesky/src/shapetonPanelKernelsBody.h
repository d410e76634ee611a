// The body of the kernels of panels, compiled once for each instruction set: SHAPETON_LANES doubles to a vector, tiles
// of SHAPETON_TILE_VECTORS vectors x SHAPETON_TILE_COLUMNS columns, which fill the registers. No include guard and no
// standard library: see shapetonPanelKernels.h.
#include "shapetonPanelKernels.h"

namespace shapeton
{
namespace PanelKernels
{
namespace
{
constexpr int lanes = SHAPETON_LANES;
/** Columns that are eliminated together. */
constexpr int blockWidth = 8;

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

/** C -= A B^T for a tile: `b` points to its rows of B. */
template <int VVectors, int VColumns>
SHAPETON_INLINE void
SubtractTile(int depth, const double * a, const double * b, std::ptrdiff_t stride, const Panel & C)
{
  Vector sum[VColumns][VVectors] = {};
  for (int k = 0; k < depth; ++k)
  {
    Vector column[VVectors];
    for (int v = 0; v < VVectors; ++v)
    {
      column[v] = Load(a + v * lanes);
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
SubtractRows(int columns, int depth, const double * a, const double * b, std::ptrdiff_t stride, Panel C)
{
  int column = 0;
  for (; column + SHAPETON_TILE_COLUMNS <= columns; column += SHAPETON_TILE_COLUMNS)
  {
    SubtractTile<VVectors, SHAPETON_TILE_COLUMNS>(depth, a, b, stride, C);
    b += SHAPETON_TILE_COLUMNS;
    C.data += SHAPETON_TILE_COLUMNS * C.stride;
  }
  for (; column < columns; ++column)
  {
    SubtractTile<VVectors, 1>(depth, a, b, stride, C);
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
SubtractSquare(int rows, int begin, int end, int depth, const Panel & A, const Panel & C)
{
  constexpr int  tileRows = SHAPETON_TILE_VECTORS * lanes;
  double * const first = C.data + begin * C.stride;
  int            row = begin;
  for (; row + tileRows <= rows; row += tileRows)
  {
    SubtractRows<SHAPETON_TILE_VECTORS>(
      Smaller(row + tileRows, end) - begin, depth, A.data + row, A.data + begin, A.stride, { first + row, C.stride });
  }
  for (; row < rows; row += lanes)
  {
    SubtractRows<1>(Smaller(Smaller(row + lanes, end), rows) - begin,
                    depth,
                    A.data + row,
                    A.data + begin,
                    A.stride,
                    { first + row, C.stride });
  }
}

/** Eliminates the columns [begin, end) of a panel from which those before have been subtracted. */
SHAPETON_INLINE int
FactorBlock(int rows, int begin, int end, const Panel & panel)
{
  for (int j = begin; j < end; ++j)
  {
    double * const column = panel.data + j * panel.stride;
    const double   pivot = column[j];
    if (!(pivot > 0.0 && pivot < 1e300))
    {
      return j;
    }
    const double root = __builtin_sqrt(pivot);
    const double inverse = 1.0 / root;
    for (int i = begin; i < rows; i += lanes)
    {
      Save(Load(column + i) * inverse, column + i);
    }
    column[j] = root;
    for (int c = j + 1; c < end; ++c)
    {
      double * const next = panel.data + c * panel.stride;
      const double   factor = column[c];
      for (int i = begin; i < rows; i += lanes)
      {
        Save(Load(next + i) - Load(column + i) * factor, next + i);
      }
    }
  }
  return -1;
}

int
Factor(int rows, int width, const Panel & panel)
{
  for (int begin = 0; begin < width; begin += blockWidth)
  {
    const int end = Smaller(begin + blockWidth, width);
    if (begin > 0)
    {
      SubtractSquare(rows, begin, end, begin, panel, panel);
    }
    const int failure = FactorBlock(rows, begin, end, panel);
    if (failure >= 0)
    {
      return failure;
    }
  }
  return -1;
}

const Set kernels{ SHAPETON_NAME, Factor, SubtractSquare };
} // namespace
} // namespace PanelKernels
} // namespace shapeton
