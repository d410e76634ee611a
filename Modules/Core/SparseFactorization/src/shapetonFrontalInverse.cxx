#include "shapetonFrontalInverse.h"

#include "shapetonKernelSets.h"

#include <algorithm>
#include <complex>
#include <cstring>

namespace shapeton
{
using FrontKernels::PaddedRows;
using FrontKernels::Store;

namespace
{
std::ptrdiff_t
ElementsOf(int rows, int columns)
{
  return static_cast<std::ptrdiff_t>(PaddedRows(rows)) * columns;
}

FrontKernels::Block
BlockAt(double * data, int rows, int columns)
{
  return { data, PaddedRows(rows), ElementsOf(rows, columns) };
}

void
Clear(const FrontKernels::Block & block)
{
  std::memset(block.data, 0, 2 * block.plane * sizeof(double));
}

void
Put(const FrontKernels::Block & block, int row, int column, const std::complex<double> & value)
{
  double * const at = block.data + column * block.stride + row;
  at[0] = value.real();
  at[block.plane] = value.imag();
}

std::complex<double>
Get(const FrontKernels::Block & block, int row, int column)
{
  const double * const at = block.data + column * block.stride + row;
  return { at[0], at[block.plane] };
}

/** Scatters and adds a column of a child's update to a front. */
void
AddColumn(const double * from,
          std::ptrdiff_t fromPlane,
          const int *    place,
          int            number,
          double *       to,
          std::ptrdiff_t plane)
{
  for (int i = 0; i < number; ++i)
  {
    to[place[i]] += from[i];
    to[place[i] + plane] += from[i + fromPlane];
  }
}

void
TakeColumn(const double * from,
           std::ptrdiff_t fromPlane,
           const int *    place,
           int            number,
           double *       to,
           std::ptrdiff_t plane)
{
  for (int i = 0; i < number; ++i)
  {
    to[i] = from[place[i]];
    to[i + plane] = from[place[i] + fromPlane];
  }
  for (int i = number; i < PaddedRows(number); ++i)
  {
    to[i] = 0.0;
    to[i + plane] = 0.0;
  }
}

/** Copies the transpose of a rows x columns block. */
void
Transpose(const FrontKernels::Block & from, int rows, int columns, const FrontKernels::Block & to)
{
  for (int j = 0; j < columns; ++j)
  {
    for (int i = 0; i < rows; ++i)
    {
      const double * const at = from.data + j * from.stride + i;
      double * const       destination = to.data + i * to.stride + j;
      destination[0] = at[0];
      destination[to.plane] = at[from.plane];
    }
  }
}
} // namespace

FactorLayout::FactorLayout(const Supernodes & supernodes) : begin(1, 0)
{
  for (int s = 0; s < supernodes.Number(); ++s)
  {
    const int width = supernodes.Width(s);
    const int rows = supernodes.NumberOfRows(s);
    begin.push_back(begin.back() + 2 * (ElementsOf(width, width) + ElementsOf(rows, width)));
    largestWidth = std::max(largestWidth, width);
    largestRows = std::max(largestRows, rows);
  }
}

FrontWorkspace::FrontWorkspace(const FactorLayout & layout)
  : panel(2 * std::max(ElementsOf(layout.largestRows, layout.largestWidth),
                       ElementsOf(layout.largestWidth, layout.largestRows)))
  , columns(2 * PaddedRows(layout.largestWidth))
  , places(layout.largestRows)
{}

FrontalInverse::FrontalInverse(const Supernodes &   supernodes,
                               const FactorLayout & layout,
                               SymmetricElements    elements,
                               AlignedBuffer        factor)
  : m_Supernodes(supernodes)
  , m_Layout(layout)
  , m_Kernels(BestKernels<FrontKernels::Set>())
  , m_Elements(std::move(elements))
  , m_Factor(std::move(factor))
  , m_Updates(supernodes.Number())
  , m_Fronts(supernodes.Number())
  , m_ChildrenToCome(supernodes.numberOfChildren)
{}

FrontKernels::Block
FrontalInverse::PivotBlock(int s) const
{
  const int width = m_Supernodes.Width(s);
  return BlockAt(m_Factor.Data() + m_Layout.begin[s], width, width);
}

FrontKernels::Block
FrontalInverse::Multipliers(int s) const
{
  const int width = m_Supernodes.Width(s);
  return BlockAt(
    m_Factor.Data() + m_Layout.begin[s] + 2 * ElementsOf(width, width), m_Supernodes.NumberOfRows(s), width);
}

FrontKernels::Block
FrontalInverse::UpdateBlock(int s) const
{
  const int rows = m_Supernodes.NumberOfRows(s);
  return BlockAt(m_Updates[s].Data(), rows, rows);
}

/** The front of the inverse: its rows first, then its own columns, aligned to the row group. */
FrontKernels::Block
FrontalInverse::InverseFront(int s) const
{
  const int rows = m_Supernodes.NumberOfRows(s);
  const int width = m_Supernodes.Width(s);
  const int order = PaddedRows(rows) + PaddedRows(width);
  return { m_Fronts[s].Data(), order, static_cast<std::ptrdiff_t>(order) * (rows + width) };
}

void
FrontalInverse::AssembleEntries(int s, const Block & pivots, const Block & panel) const
{
  const int width = m_Supernodes.Width(s);
  for (std::size_t e = m_Supernodes.entryBegin[s]; e < m_Supernodes.entryBegin[s + 1]; ++e)
  {
    const auto & entry = m_Supernodes.entries[e];
    const auto value = entry.source < 0 ? m_Elements.diagonal[-1 - entry.source] : m_Elements.offDiagonal[entry.source];
    if (entry.row < width)
    {
      Put(pivots, entry.row, entry.column, value);
    }
    else
    {
      Put(panel, entry.row - width, entry.column, value);
    }
  }
}

/** Adds the lower triangle of a child's update to the front; its indices ascend, so the result is a lower triangle,
 * too. */
void
FrontalInverse::AddUpdate(int child, const Block & pivots, const Block & panel, const Block & update) const
{
  const int         width = m_Supernodes.Width(m_Supernodes.parent[child]);
  const int         number = m_Supernodes.NumberOfRows(child);
  const int * const place = m_Supernodes.placeInParent.data() + m_Supernodes.rowBegin[child];
  const int         own = static_cast<int>(std::lower_bound(place, place + number, width) - place);
  const Block       from = this->UpdateBlock(child);
  for (int j = 0; j < number; ++j)
  {
    const double * const column = from.data + j * from.stride;
    if (j < own)
    {
      double * const top = pivots.data + place[j] * pivots.stride;
      double * const below = panel.data + place[j] * panel.stride - width;
      AddColumn(column + j, from.plane, place + j, own - j, top, pivots.plane);
      AddColumn(column + own, from.plane, place + own, number - own, below, panel.plane);
    }
    else
    {
      double * const below = update.data + (place[j] - width) * update.stride - width;
      AddColumn(column + j, from.plane, place + j, number - j, below, update.plane);
    }
  }
}

void
FrontalInverse::Factor(int s, FrontWorkspace & workspace)
{
  const int   width = m_Supernodes.Width(s);
  const int   rows = m_Supernodes.NumberOfRows(s);
  const Block pivots = this->PivotBlock(s);
  const Block multipliers = this->Multipliers(s);
  const Block panel = BlockAt(workspace.panel.Data(), rows, width);
  m_Updates[s] = AlignedBuffer(2 * ElementsOf(rows, rows));
  const Block update = this->UpdateBlock(s);
  Clear(pivots);
  Clear(panel);
  Clear(update);
  this->AssembleEntries(s, pivots, panel);
  for (int child = m_Supernodes.lastChild[s]; child != -1; child = m_Supernodes.sibling[child])
  {
    this->AddUpdate(child, pivots, panel, update);
    m_Updates[child].Free();
  }
  for (int j = 1; j < width; ++j) // the upper triangle
  {
    for (int i = 0; i < j; ++i)
    {
      Put(pivots, i, j, Get(pivots, j, i));
    }
  }
  m_Kernels.Invert(width, pivots, workspace.columns.Data());
  m_Kernels.Multiply(PaddedRows(rows),
                     width,
                     width,
                     panel,
                     { pivots.data, 1, pivots.stride, pivots.plane },
                     multipliers,
                     Store::Assign,
                     false);
  m_Kernels.Multiply(PaddedRows(rows),
                     rows,
                     width,
                     multipliers,
                     { panel.data, panel.stride, 1, panel.plane },
                     update,
                     Store::Subtract,
                     true);
}

void
FrontalInverse::Gather(int s, FrontWorkspace & workspace)
{
  const int rows = m_Supernodes.NumberOfRows(s);
  const int width = m_Supernodes.Width(s);
  m_Fronts[s] = AlignedBuffer(2 * static_cast<std::size_t>(PaddedRows(rows) + PaddedRows(width)) * (rows + width));
  const int parent = m_Supernodes.parent[s];
  if (parent == -1)
  {
    return;
  }
  const Block       front = this->InverseFront(s);
  const Block       from = this->InverseFront(parent);
  const int         parentWidth = m_Supernodes.Width(parent);
  const int         parentRows = m_Supernodes.NumberOfRows(parent);
  const int * const place = m_Supernodes.placeInParent.data() + m_Supernodes.rowBegin[s];
  for (int i = 0; i < rows; ++i)
  {
    workspace.places[i] = place[i] < parentWidth ? PaddedRows(parentRows) + place[i] : place[i] - parentWidth;
  }
  for (int j = 0; j < rows; ++j)
  {
    const int column = place[j] < parentWidth ? parentRows + place[j] : place[j] - parentWidth;
    TakeColumn(from.data + column * from.stride,
               from.plane,
               workspace.places.data(),
               rows,
               front.data + j * front.stride,
               front.plane);
  }
  if (--m_ChildrenToCome[parent] == 0)
  {
    m_Fronts[parent].Free();
  }
}

void
FrontalInverse::GatherChildren(int s, FrontWorkspace & workspace)
{
  for (int child = m_Supernodes.lastChild[s]; child != -1; child = m_Supernodes.sibling[child])
  {
    this->Gather(child, workspace);
  }
}

/** Z_RI = -Z_RR G and Z_II = P^-1 - G^T Z_RI. */
void
FrontalInverse::InvertPivots(int s, const Block & front, FrontWorkspace & workspace) const
{
  const int   width = m_Supernodes.Width(s);
  const int   rows = m_Supernodes.NumberOfRows(s);
  const Block pivots = this->PivotBlock(s);
  const Block multipliers = this->Multipliers(s);
  const Block below{ front.data + rows * front.stride, front.stride, front.plane };
  const Block own{ below.data + PaddedRows(rows), front.stride, front.plane };
  for (int j = 0; j < width; ++j)
  {
    const double * const from = pivots.data + j * pivots.stride;
    std::copy_n(from, PaddedRows(width), own.data + j * own.stride);
    std::copy_n(from + pivots.plane, PaddedRows(width), own.data + j * own.stride + own.plane);
  }
  if (rows == 0)
  {
    return;
  }
  m_Kernels.Multiply(PaddedRows(rows),
                     width,
                     rows,
                     front,
                     { multipliers.data, 1, multipliers.stride, multipliers.plane },
                     below,
                     Store::Negate,
                     false);
  const Block transposed = BlockAt(workspace.panel.Data(), width, rows);
  Clear(transposed);
  Transpose(multipliers, rows, width, transposed);
  m_Kernels.Multiply(PaddedRows(width),
                     width,
                     rows,
                     transposed,
                     { below.data, 1, below.stride, below.plane },
                     own,
                     Store::Subtract,
                     false);
}

void
FrontalInverse::TakeElements(int s, const Block & front)
{
  const int width = m_Supernodes.Width(s);
  const int rows = m_Supernodes.NumberOfRows(s);
  const int firstOwn = PaddedRows(rows);
  for (std::size_t e = m_Supernodes.entryBegin[s]; e < m_Supernodes.entryBegin[s + 1]; ++e)
  {
    const auto & entry = m_Supernodes.entries[e];
    const auto   value = Get(front, entry.row < width ? firstOwn + entry.row : entry.row - width, rows + entry.column);
    (entry.source < 0 ? m_Elements.diagonal[-1 - entry.source] : m_Elements.offDiagonal[entry.source]) = value;
  }
}

void
FrontalInverse::Invert(int s, FrontWorkspace & workspace)
{
  if (!m_Fronts[s])
  {
    this->Gather(s, workspace);
  }
  const Block front = this->InverseFront(s);
  this->InvertPivots(s, front, workspace);
  this->TakeElements(s, front);
  if (m_Supernodes.numberOfChildren[s] == 0)
  {
    m_Fronts[s].Free();
    return;
  }
  const int   width = m_Supernodes.Width(s);
  const int   rows = m_Supernodes.NumberOfRows(s);
  const Block below{ front.data + rows * front.stride, front.stride, front.plane };
  Transpose(below, rows, width, { front.data + PaddedRows(rows), front.stride, front.plane });
}
} // namespace shapeton
