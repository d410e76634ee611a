#ifndef itkDistanceToBackground_h
#define itkDistanceToBackground_h

#include "itkColonVolume.h"

namespace itk
{
/** For each voxel with a non-zero mask the squared distance in mm to the centre of the nearest voxel with a zero mask,
 * 0 for these; exact. What lies beyond the grid counts as neither; without any zero voxel all are 1e12.
 *
 * Lower envelopes of parabolas: Felzenszwalb and Huttenlocher, Distance transforms of sampled functions, Theory of
 * Computing 8 (2012) 415-428. */
std::vector<float>
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask);
} // namespace itk

#endif
