#ifndef shapetonNodesMetTwice_h
#define shapetonNodesMetTwice_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** Calls `visit(face, node)` for each repeated corner of a face at a node. */
template <typename TVisit>
void
ForEachNodeMetTwice(const CombinatorialMap & map, const TVisit & visit)
{
  std::vector<int> seenFrom(map.Nodes(), -1);
  for (int face = 0; face < map.Faces(); ++face)
  {
    const int first = map.FirstOfFace(face);
    int       h = first;
    do
    {
      int & seen = seenFrom[map.Node(h)];
      if (seen == face)
      {
        visit(face, map.Node(h));
      }
      seen = face;
      h = map.FaceNext(h);
    } while (h != first);
  }
}
} // namespace shapeton

#endif
