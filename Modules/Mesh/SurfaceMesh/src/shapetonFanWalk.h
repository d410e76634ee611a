#ifndef shapetonFanWalk_h
#define shapetonFanWalk_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** Whether a walk around a vertex across edges with two faces visits all of its faces. True for nearly every vertex and
 * computed without allocation; otherwise SurfaceConnectivity::FanOfFaces() returns the fans. */
inline bool
IsOneFan(const SurfaceConnectivity & connectivity, const FaceMatrix & F, int vertex)
{
  const IndexRange faces = connectivity.FacesOfVertex(vertex);
  if (faces.size() == 0)
  {
    return false;
  }
  const auto edgesAt = [&](int face) {
    const int k = F(face, 0) == vertex ? 0 : F(face, 1) == vertex ? 1 : 2;
    return std::array<int, 2>{ connectivity.EdgeOfFace(face, k), connectivity.EdgeOfFace(face, (k + 2) % 3) };
  };
  int met = 1;
  for (int edge : edgesAt(faces[0])) // one direction, and from a boundary also the other
  {
    int face = faces[0];
    for (IndexRange sides = connectivity.FacesOfEdge(edge); sides.size() == 2; sides = connectivity.FacesOfEdge(edge))
    {
      face = sides[0] == face ? sides[1] : sides[0];
      if (face == faces[0])
      {
        return met == faces.size();
      }
      ++met;
      const auto edges = edgesAt(face);
      edge = edges[0] == edge ? edges[1] : edges[0];
    }
    if (connectivity.IsNonManifoldEdge(edge))
    {
      return false;
    }
  }
  return met == faces.size();
}
} // namespace shapeton

#endif
