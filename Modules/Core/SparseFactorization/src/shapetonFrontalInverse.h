#ifndef shapetonFrontalInverse_h
#define shapetonFrontalInverse_h

#include "shapetonAlignedBuffer.h"
#include "shapetonFrontKernels.h"
#include "shapetonSelectedInversion.h"
#include "shapetonSupernodes.h"

#include <utility>

namespace shapeton
{
/** Storage layout of the factor: for each supernode the inverse pivot block, then G. */
struct FactorLayout
{
  explicit FactorLayout(const Supernodes & supernodes);

  std::vector<std::size_t> begin; ///< in doubles; one entry more than supernodes
  int                      largestWidth{ 0 };
  int                      largestRows{ 0 };
};

/** Per-thread buffers. */
struct FrontWorkspace
{
  explicit FrontWorkspace(const FactorLayout & layout);

  AlignedBuffer    panel;   ///< rows x width
  AlignedBuffer    columns; ///< two columns of a pivot block
  std::vector<int> places;
};

/** Selected inversion of one matrix, supernode by supernode: Factor() for all, children before parents, then
 * Invert() for all, parents before children. Calls for supernodes of different subtrees may run concurrently. */
class FrontalInverse
{
public:
  /** `elements` are replaced by elements of the inverse. `factor` is memory for layout.begin.back() doubles. */
  FrontalInverse(const Supernodes &   supernodes,
                 const FactorLayout & layout,
                 SymmetricElements    elements,
                 AlignedBuffer        factor);

  void
  Factor(int s, FrontWorkspace & workspace);
  /** Copies the data for Invert() from the parent's front. Called by Invert() if necessary. */
  void
  Gather(int s, FrontWorkspace & workspace);
  void
  GatherChildren(int s, FrontWorkspace & workspace);
  void
  Invert(int s, FrontWorkspace & workspace);
  const SymmetricElements &
  Elements() const
  {
    return m_Elements;
  }
  /** Reuses the memory for another matrix after this one is complete. */
  AlignedBuffer
  TakeFactor()
  {
    return std::move(m_Factor);
  }

private:
  using Block = FrontKernels::Block;
  Block
  PivotBlock(int s) const;
  Block
  Multipliers(int s) const;
  Block
  UpdateBlock(int s) const;
  Block
  InverseFront(int s) const;

  void
  AssembleEntries(int s, const Block & pivots, const Block & panel) const;
  void
  AddUpdate(int child, const Block & pivots, const Block & panel, const Block & update) const;
  void
  InvertPivots(int s, const Block & front, FrontWorkspace & workspace) const;
  void
  TakeElements(int s, const Block & front);

  const Supernodes &         m_Supernodes;
  const FactorLayout &       m_Layout;
  const FrontKernels::Set &  m_Kernels;
  SymmetricElements          m_Elements;
  AlignedBuffer              m_Factor;
  std::vector<AlignedBuffer> m_Updates; ///< of each supernode until its parent has assembled it
  std::vector<AlignedBuffer> m_Fronts;  ///< of the inverse, until all children have copied their parts
  std::vector<int>           m_ChildrenToCome;
};
} // namespace shapeton

#endif
