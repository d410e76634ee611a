#ifndef shapetonCutGraph_h
#define shapetonCutGraph_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** Edges that open a surface to a disk. */
struct CutGraph
{
  /** For each edge, whether it is cut; boundary edges are not. */
  std::vector<char> isCut;
  /** 2 genus edges; crossing them from the disk generates, with the boundaries, the fundamental group. */
  std::vector<int> generators;
};

/** A cut graph of short loops: a tree of shortest paths and a tree of faces that crosses the remaining edges, longest
 * detours first, leave the generators; dangling edges are removed (Erickson and Whittlesey 2005, greedy homotopy
 * basis). It connects all boundaries and the given vertices. \pre One oriented manifold component. */
CutGraph
FindCutGraph(const SurfaceConnectivity & connectivity,
             const Eigen::VectorXd &     lengths,
             const std::vector<int> &    vertices);
} // namespace shapeton

#endif
