#ifndef shapetonRunPieces_h
#define shapetonRunPieces_h

#include "shapetonRuns.h"

namespace shapeton
{
/** A labelled part of a RunSet. */
struct RunPiece
{
  std::size_t voxels{ 0 };
  VoxelBox    box;
};

/** The pieces 1, 2, ... of labelled runs; entry 0 counts for nothing. */
std::vector<RunPiece>
PiecesOfRuns(const RunSet & set, const RunLabels & labels);

/** The voxels of one label in a box of the grid. */
std::vector<unsigned char>
MaskOfRuns(const ColonGrid & grid, const RunSet & set, const RunLabels & labels, int label, const VoxelBox & box);

/** The middle of the largest ball in a piece. */
struct DeepestVoxel
{
  std::array<int, 3> voxel{ { 0, 0, 0 } };
  double             radius{ 0.0 }; ///< mm
};

DeepestVoxel
FindDeepestVoxel(const ColonGrid & grid,
                 const RunSet &    set,
                 const RunLabels & labels,
                 int               label,
                 const RunPiece &  piece);
} // namespace shapeton

#endif
