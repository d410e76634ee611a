#ifndef shapetonTracedMap_h
#define shapetonTracedMap_h

#include "shapetonEmbeddingCertificate.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace shapeton
{
/** Reason for rejecting a certificate. */
class Refusal : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A rotation system with traced faces; each face is to the left of its half-edges. */
struct TracedMap
{
  /** Throws Refusal with the prefix `what` unless `rotation` lists each half-edge once, node by node. */
  TracedMap(const Graph & graph, const std::vector<int> & rotation, const std::string & what);

  int
  Node(int halfEdge) const
  {
    return node[halfEdge];
  }
  int
  HalfEdges() const
  {
    return static_cast<int>(node.size());
  }
  int
  FaceNext(int halfEdge) const
  {
    return previous[halfEdge ^ 1];
  }
  /** Sum of the genera of the components; a node without edges has genus 0. */
  int
  Genus() const;

  int              nodes;
  std::vector<int> node;
  std::vector<int> next; ///< counter-clockwise around the node
  std::vector<int> previous;
  std::vector<int> face; ///< numbered in the order of the lowest half-edges
  std::vector<int> firstOfFace;
  std::vector<int> firstOfNode; ///< the first in the rotation; -1 for a node without edges
  int              components{ 0 };
  int              isolatedNodes{ 0 };

private:
  void
  TraceFaces();
  void
  CountComponents();
};

/** Disjoint sets; a separate implementation, because the verifier is independent of the code it checks. */
class UnitedElements
{
public:
  explicit UnitedElements(int size);

  int
  Find(int element);

  /** Returns false if both were already in one set. */
  bool
  Unite(int first, int second);

private:
  std::vector<int> m_Parent;
};
} // namespace shapeton

#endif
