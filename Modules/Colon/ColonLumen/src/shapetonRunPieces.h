#ifndef shapetonRunPieces_h
#define shapetonRunPieces_h

#include "shapetonColonVolume.h"
#include "shapetonVoxelRuns.h"

namespace shapeton
{
/** A labelled part of a VoxelRuns. */
struct RunPiece
{
  std::size_t voxels{ 0 };
  VoxelBox    box;
};

/** The pieces 1, 2, ... of labelled runs; entry 0 counts for nothing. */
std::vector<RunPiece>
PiecesOfRuns(const VoxelRuns & set, const RunLabels & labels);

/** The voxels of one label in a box of the grid. */
std::vector<unsigned char>
MaskOfRuns(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels, int label, const VoxelBox & box);

/** The middle of the largest ball in a piece. */
struct DeepestVoxel
{
  std::array<int, 3> voxel{ { 0, 0, 0 } };
  double             radius{ 0.0 }; ///< mm
};

DeepestVoxel
FindDeepestVoxel(const ColonGrid & grid,
                 const VoxelRuns & set,
                 const RunLabels & labels,
                 int               label,
                 const RunPiece &  piece);
} // namespace shapeton

#endif
