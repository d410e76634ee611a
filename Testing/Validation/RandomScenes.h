#ifndef RandomScenes_h
#define RandomScenes_h

#include "itkImage.h"

/** A volume and the label of the object at each voxel; 0 outside of all. */
struct SceneVolume
{
  itk::Image<float, 3>::Pointer         image;
  itk::Image<unsigned char, 3>::Pointer labels;
};

/** A scene of 96^3 voxels with 3 to 12 objects of random kind, size, place and intensity.
 *
 * Balls, ellipsoids, boxes, cylinders, rings and blobs, some with a texture, a brighter cortex, a core or a shell;
 * tubes and sheets. Some objects touch, some are cut by the border. In about half of the scenes a body contains them.
 * Blur of 0.4 to 1.4 voxels, a bias field, white or correlated noise of 0 to 5 % of the range. Odd seeds have at most
 * 256 intensities, some with removed background; even seeds have those of a CT. The volume depends on the seed only.
 */
SceneVolume
RandomScene(unsigned int seed);

#endif
