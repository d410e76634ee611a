#ifndef ObjectPeers_h
#define ObjectPeers_h

#include "ReferenceParts.h"

/** Dice coefficients of the parts, in their order, with the region of another method that fits each best. */
struct ObjectPeer
{
  std::string         name;
  std::vector<double> dice;
};

/** Max-tree, min-tree and quasi-flat zones of the intensity smoothed by 0.8 voxel and of the logarithm of heat, and
 * ITK's morphological watershed of the gradient at two levels. Nodes and levels are chosen per part with knowledge of
 * the parts. */
std::vector<ObjectPeer>
MeasurePeers(const itk::Image<float, 3> * image, const itk::Image<float, 3> * heat, const ReferenceParts & parts);

/** scikit-image's random walker with one seed at the deepest voxel of a part; the other label has the voxels on the
 * border of the volume that are not of the part. Empty if scikit-image is not installed. */
std::vector<double>
DiceOfRandomWalker(const itk::Image<float, 3> * image, const ReferenceParts & parts);

#endif
