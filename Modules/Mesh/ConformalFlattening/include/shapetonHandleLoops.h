#ifndef shapetonHandleLoops_h
#define shapetonHandleLoops_h

#include "shapetonSurfaceHandles.h"

namespace shapeton
{
/** A closed path of edges whose cut opens a handle. \ingroup ShapetonConformalFlattening */
struct HandleLoop
{
  /** Each vertex once; the last one shares an edge with the first. */
  std::vector<int> vertices;
  /** Length along the edges (mm). */
  double length{ 0.0 };
};

/** Finds short loops that can be cut together without disconnecting the surface, shortest first. They are disjoint and
 * avoid boundaries. If the surface has handles, there is at least one loop, unless all loops touch a boundary, and at
 * most one for each handle.
 *
 * Each handle has two kinds of loops, around it and through it (dissertation 5.3.2). The shorter ones are found first,
 * and loops that cross them are left out. A loop is essential, that is, it does not separate the surface, if it crosses
 * one of 2 genus dual loops an odd number of times. These come from a tree of edges and a tree of faces (Eppstein,
 * Dynamic generators of topologically embedded graphs, 2003), with a disc in each boundary. The shortest essential loop
 * through a vertex closes two branches of its tree of shortest paths (Erickson and Har-Peled, Optimally cutting a
 * surface into a disk, 2004). Loops from one tree of the whole surface are shortened by trees rooted at their own
 * vertices, with a radius of 3/4 of the loop length. The result is a local minimum: none of these trees closes a
 * shorter one.
 *
 * On a tube with the point array `arcLength`, loops around the tube are left out: those that cross an odd number of
 * times the shortest path from end to end without jumps of arcLength. Otherwise, where a tube is narrower than a
 * contact between two of its parts, the shortest loop would run around the tube.
 *
 * \pre One oriented manifold component; otherwise throws InputError. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::vector<HandleLoop>
                                   FindHandleLoops(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity);

/** A surface whose handles were cut along loops. \ingroup ShapetonConformalFlattening */
struct HandleCuts
{
  /** The faces of the input in their order, then two discs for each loop. Arrays as in HandleRemoval; vertices of the
   * input keep their indices. */
  SurfaceMesh mesh;
  /** One for each loop, in the order of the cuts; `radius` and `vertices` are those of the loop on the input,
   * `flatPlace` is 0. */
  std::vector<SurfaceHandle> handles;
  int                        filledFaces{ 0 };
  /** Length of the longest loop (mm). */
  double longestLoop{ 0.0 };
  /** Genus of the remaining handles: those whose loops all touch a boundary. */
  int genus{ 0 };
};

/** Removes handles by conventional topological denoising (dissertation 5.3.2): cuts each along a short loop and fills
 * both rims with discs (Liepa 2003, as RemoveHandles()). Repeats FindHandleLoops() until no loop is found. Boundaries
 * and the shape elsewhere are unchanged. Throws InputError as FindHandleLoops(). \ingroup ShapetonConformalFlattening
 */
ShapetonConformalFlattening_EXPORT HandleCuts
CutHandles(SurfaceMesh mesh);
} // namespace shapeton

#endif
