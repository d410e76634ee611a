#ifndef shapetonPieceLine_h
#define shapetonPieceLine_h

#include "shapetonMinimalPath.h"

#include <memory>

namespace shapeton
{
/** Extension of the path of a piece from its core into a tapering end. */
struct PieceEnd
{
  /** The last node shared with the core. */
  int              branch{ 0 };
  std::vector<int> nodes;
  /** Path length (mm) by which the farthest tip exceeds this one. */
  double shortfall{ 0.0 };
};

/** The path through one piece of lumen, from end 0 to end 1. */
struct PieceLine
{
  int component{ 0 };
  /** Nodes between the wide ends. */
  std::vector<int>        core;
  std::array<PieceEnd, 2> ends;
  /** Alternative tips of the ends, beyond which the lumen may continue; the first is the tip in `ends`. */
  std::array<std::vector<PieceEnd>, 2> tips;
  /** Volume of the piece, mm^3. */
  double volume{ 0.0 };
  /** The path tree of the line, from one end of the core; may be null. */
  std::shared_ptr<const PathTree> paths;

  /** All nodes, from end 0 to end 1, with the ends extended if requested. */
  std::vector<int>
  Nodes(bool prolongs0, bool prolongs1) const;
  void
  Reverse();
};

/** Data for the path search in a lumen. */
struct LumenNetwork
{
  explicit LumenNetwork(const LumenGrid & lumenGrid);

  const LumenGrid & grid;
  LumenCells        cells;
  /** Minimum radius of the lumen at the ends of a piece, mm: 8, or half the usual radius if the lumen is narrow. */
  double   coreRadius;
  CellTree tree;
  /** Indices (in LumenCells::passages) of holes between the end of one stretch of colon and the side of another. */
  std::vector<int> cuts;
};

/** The path between the two ends of the piece that contains `node`. */
PieceLine
TracePiece(const LumenNetwork & network, int node, int exponent);

/** The line with end 0 extended down the anal canal to the caudal tip of the rectum. */
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
