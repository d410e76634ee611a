#ifndef shapetonSurfaceLayout_h
#define shapetonSurfaceLayout_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonPlaneMotion.h"

#include <vector>

namespace shapeton
{
/** \brief A packing of a surface of genus >= 1, cut open along a graph and laid out in the plane or the Poincare disk.
 *
 * The nodes are laid out along the shortest-path tree from the center of the largest circle, which is the origin. The
 * other uncut edges form a tree of the dual graph with the longest loops. The remaining 2g loops, and their deck
 * transformations, are therefore the shortest for one base point (Erickson and Whittlesey 2005).
 * \ingroup ShapetonRicciFlowEmbedding */
class ShapetonRicciFlowEmbedding_EXPORT SurfaceLayout
{
public:
  /** \pre `map` has genus 1 and a Euclidean packing, or genus 2 or higher and a hyperbolic one. Both must outlive the
   * layout. */
  SurfaceLayout(const CombinatorialMap & map, const CirclePacking & packing);

  /** For each node, the motion that maps the origin to its lift and the real axis to its first half-edge. */
  const std::vector<PlaneMotion> &
  Frames() const
  {
    return m_Frames;
  }
  /** The half-edge that leads to each node along the tree; -1 for the root. */
  const std::vector<int> &
  Arrivals() const
  {
    return m_Arrivals;
  }
  /** Frame of the end node, reached along a half-edge from the frame of its start node. */
  PlaneMotion
  FrameAcross(int halfEdge) const;
  /** The deck transformation from the frame of the end node to FrameAcross(). */
  PlaneMotion
  DeckTransformationOf(int halfEdge) const;
  /** Lift of a face, adjacent to the lift of the start node of its lowest half-edge. */
  PlaneMotion::Complex
  FaceCenter(int face) const;

  /** The half-edges 2e of the 2g edges that, with the tree, cut the surface into one disk; ascending. */
  const std::vector<int> &
  CutHalfEdges() const
  {
    return m_Cut;
  }
  /** Boundary word of the disk: k + 1 for half-edge CutHalfEdges()[k], -(k + 1) for its twin. Each letter denotes its
   * deck transformation; their product in this order is the identity. */
  const std::vector<int> &
  Word() const
  {
    return m_Word;
  }

private:
  void
  BuildFrames();
  void
  FindCut(const std::vector<double> & distances);
  void
  ReadWord(const std::vector<char> & isCrossed);

  const CombinatorialMap & m_Map;
  const CirclePacking &    m_Packing;
  std::vector<double>      m_Angles;
  std::vector<PlaneMotion> m_Frames;
  std::vector<int>         m_Arrivals;
  std::vector<int>         m_Cut;
  std::vector<int>         m_Word;
};

/** \brief The words of a canonical fundamental polygon: A1, B1, ... Ag, Bg with A1 B1 A1^-1 B1^-1 ... equal to `word`
 * in the free group.
 *
 * A word U a P b Q a^-1 R b^-1 S yields A = U a Q^-1 R^-1 U^-1, B = U R Q P b R^-1 U^-1 and the remaining word U R Q P
 * S. Throws std::invalid_argument unless the word describes a closed orientable surface cut into one disk.
 * \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT std::vector<std::vector<int>>
                                  CanonicalWords(const std::vector<int> & word);

/** The cyclic rotation of a word of disk motions with the smallest partial products, because rounding errors of the
 * product grow with the square of their size. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT std::vector<int>
CenteredWord(const std::vector<PlaneMotion> & generators, const std::vector<int> & word);

/** A reduced basis of the lattice of two translations: |w1| <= |w2|, |Re(conj(w1) w2)| <= |w1|^2 / 2, Im(conj(w1) w2) >
 * 0. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT std::array<std::complex<double>, 2>
                                  ReducedLattice(std::complex<double> w1, std::complex<double> w2);

/** \brief Motions of the Poincare disk that satisfy a relation to 300 digits.
 *
 * The generators come from radii in double precision, so their relation holds to about 1e-11 times the matrix size.
 * Newton's method finds the smallest change of all generators that makes the relation exact, which keeps long words
 * meaningful. \ingroup ShapetonRicciFlowEmbedding */
struct DeckRelation
{
  /** The corrected generators, rounded. */
  std::vector<PlaneMotion> generators;
  /** Whether they were corrected; false if the residual exceeds 0.1, for genera of about 30 or higher. */
  bool isRefined{ false };
  /** Largest |product - identity| of the relation: with the given generators, with the corrected and rounded ones, and
   * for the product of commutators of `canonicalWords` with the exact ones. */
  double givenResidual{ 0.0 };
  double residual{ 0.0 };
  double canonicalResidual{ 0.0 };
  /** Motions of the canonical words, rounded; empty for words of more than 160 letters (genus 40), for which the
   * residual is also 0. */
  std::vector<PlaneMotion> canonical;
};

ShapetonRicciFlowEmbedding_EXPORT DeckRelation
RefineDeckRelation(const std::vector<PlaneMotion> &      generators,
                   const std::vector<int> &              word,
                   const std::vector<std::vector<int>> & canonicalWords);

/** Largest difference between a product of disk motions, given by letters, and plus or minus the identity, in double
 * precision. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT double
WordResidual(const std::vector<PlaneMotion> & generators, const std::vector<int> & word);

/** The `number` group elements that move the origin least, the identity first: a finite part of the universal cover.
 * \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT std::vector<PlaneMotion>
                                  UniversalCover(const std::vector<PlaneMotion> & generators, int number);
} // namespace shapeton

#endif
