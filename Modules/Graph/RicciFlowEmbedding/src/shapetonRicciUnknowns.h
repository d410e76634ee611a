#ifndef shapetonRicciUnknowns_h
#define shapetonRicciUnknowns_h

#include "shapetonCirclePacking.h"

#include <array>
#include <vector>

namespace shapeton
{
/** What is known of each circle of a map before the flow. Unknown are the finite nodes, in Euclidean geometry but the
 * one of highest degree, and the finite faces that are not eliminated. */
struct RicciUnknowns
{
  RicciUnknowns(const CombinatorialMap & map, FlowGeometry geometry, const CirclesAtInfinity & infinite);

  enum class Kind : char
  {
    Unknown,
    Fixed,
    Eliminated, ///< a face whose three nodes give its radius
    Line,
    Horocycle
  };
  bool
  IsEliminated(int face) const
  {
    return faceKind[face] == Kind::Eliminated;
  }
  std::vector<double>
  StartingPoint() const;

  const CombinatorialMap & map;
  FlowGeometry             geometry;
  std::vector<Kind>        nodeKind;
  std::vector<Kind>        faceKind;
  std::vector<int>         ofNode; ///< -1: none
  std::vector<int>         ofFace;
  int                      number{ 0 };

private:
  void
  FindKinds(const CirclesAtInfinity & infinite);
  void
  FixOneNode();
};
} // namespace shapeton

#endif
