#ifndef shapetonRicciUnknowns_h
#define shapetonRicciUnknowns_h

#include "shapetonCirclePacking.h"

#include <vector>

namespace shapeton
{
/** Role of each circle of a map in the flow. Unknowns are the finite nodes (in Euclidean geometry except the one of
 * highest degree) and the finite faces that are not eliminated. */
struct RicciUnknowns
{
  RicciUnknowns(const CombinatorialMap & map, FlowGeometry geometry, const CirclesAtInfinity & infinite);

  enum class Kind : char
  {
    Unknown,
    Fixed,
    Eliminated, ///< a face with a radius determined by its three nodes
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
