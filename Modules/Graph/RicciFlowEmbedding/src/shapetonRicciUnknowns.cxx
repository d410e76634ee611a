#include "shapetonRicciUnknowns.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
bool
Flag(const std::vector<char> & flags, int i)
{
  return !flags.empty() && flags[i];
}
} // namespace

RicciUnknowns::RicciUnknowns(const CombinatorialMap &  givenMap,
                             FlowGeometry              givenGeometry,
                             const CirclesAtInfinity & infinite)
  : map(givenMap)
  , geometry(givenGeometry)
  , nodeKind(map.Nodes(), Kind::Unknown)
  , faceKind(map.Faces(), Kind::Unknown)
  , ofNode(map.Nodes(), -1)
  , ofFace(map.Faces(), -1)
{
  this->FindKinds(infinite);
  if (geometry == FlowGeometry::Euclidean)
  {
    this->FixOneNode();
  }
  for (int node = 0; node < map.Nodes(); ++node)
  {
    ofNode[node] = nodeKind[node] == Kind::Unknown ? number++ : -1;
  }
  for (int face = 0; face < map.Faces(); ++face)
  {
    ofFace[face] = faceKind[face] == Kind::Unknown ? number++ : -1;
  }
}

void
RicciUnknowns::FindKinds(const CirclesAtInfinity & infinite)
{
  for (int node = 0; node < map.Nodes(); ++node)
  {
    nodeKind[node] = Flag(infinite.lineNodes, node) ? Kind::Line : Kind::Unknown;
  }
  const std::vector<int> lengths = map.FaceLengths();
  for (int face = 0; face < map.Faces(); ++face)
  {
    bool isEliminated = lengths[face] == 3;
    int  h = map.FirstOfFace(face);
    for (int i = 0; isEliminated && i < 3; ++i, h = map.FaceNext(h))
    {
      isEliminated = nodeKind[map.Node(h)] != Kind::Line;
    }
    faceKind[face] = isEliminated ? Kind::Eliminated : Kind::Unknown;
    if (Flag(infinite.lineFaces, face))
    {
      faceKind[face] = Kind::Line;
    }
    if (Flag(infinite.horocycleFaces, face))
    {
      faceKind[face] = Kind::Horocycle;
    }
  }
}

/** Fixes one radius, because only ratios of radii are determined in the plane. */
void
RicciUnknowns::FixOneNode()
{
  const std::vector<int> degrees = map.Degrees();
  int                    fixed = -1;
  for (int node = 0; node < map.Nodes(); ++node)
  {
    if (nodeKind[node] == Kind::Unknown && (fixed < 0 || degrees[node] > degrees[fixed]))
    {
      fixed = node;
    }
  }
  if (fixed >= 0)
  {
    nodeKind[fixed] = Kind::Fixed;
  }
}

/** Initial unknowns; in hyperbolic geometry, equal circles that would fill a disk of radius 2. */
std::vector<double>
RicciUnknowns::StartingPoint() const
{
  const double radius = std::min(0.5, 2.0 / std::sqrt(static_cast<double>(map.Nodes())));
  return std::vector<double>(number, geometry == FlowGeometry::Euclidean ? 0.0 : std::log(std::tanh(0.5 * radius)));
}
} // namespace shapeton
