#ifndef shapetonPieceLine_h
#define shapetonPieceLine_h

#include "shapetonMinimalPath.h"

#include <memory>

namespace shapeton
{
/** How the path of a piece goes on from its core into a tapering end. */
struct PieceEnd
{
  /** The last node of the core that it shares. */
  int              branch{ 0 };
  std::vector<int> nodes;
  /** How much shorter than the way to the farthest tip, mm. */
  double shortfall{ 0.0 };
};

/** The path through one piece of lumen, from its end 0 to its end 1. */
struct PieceLine
{
  int component{ 0 };
  /** Nodes between the wide ends. */
  std::vector<int>        core;
  std::array<PieceEnd, 2> ends;
  /** Other tips of the ends; the lumen may go on behind any of them. The first is that of `ends`. */
  std::array<std::vector<PieceEnd>, 2> tips;
  /** mm^3 of the piece. */
  double volume{ 0.0 };
  /** The paths from one end of the core, which the line was found by; may be null. */
  std::shared_ptr<const PathTree> paths;

  /** All nodes, from end 0 to end 1, the ends prolonged where asked for. */
  std::vector<int>
  Nodes(bool prolongs0, bool prolongs1) const;
  void
  Reverse();
};

/** What the paths of a lumen are found in. */
struct LumenNetwork
{
  explicit LumenNetwork(const LumenGrid & lumenGrid);

  const LumenGrid & grid;
  LumenCells        cells;
  /** Ends are where the lumen is as wide as this, mm: 8, or half the usual radius of a narrow lumen. */
  double   coreRadius;
  CellTree tree;
  /** Indices into LumenCells::passages of holes that would hang a stretch of colon on the side of another one. */
  std::vector<int> cuts;
};

/** The path between the two ends of the piece that `node` belongs to. */
PieceLine
TracePiece(const LumenNetwork & network, int node, int exponent);

/** The same line with end 0 at the caudal tip of the rectum, down the anal canal. */
PieceLine
BeginAtAnus(const LumenNetwork & network, const PieceLine & line, int exponent);

/** The path between the same ends for another exponent. */
std::vector<int>
OtherPath(const LumenNetwork & network, const PieceLine & line, int exponent);

/** The path from a given node to the farthest end of its piece. */
PieceLine
TracePieceFrom(const LumenNetwork & network, int node, int exponent);
} // namespace shapeton

#endif
