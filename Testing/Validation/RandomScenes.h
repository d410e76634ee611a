#ifndef RandomScenes_h
#define RandomScenes_h

#include "shapetonHeatObjects.h"
#include "shapetonShapeScene.h"

/** Scene of 4 to 12 objects of random kind, size, place and intensity, some of them overlapping, some chains of bones
 * that nearly touch, some with a core of another intensity. */
shapeton::ShapeScene
RandomScene(unsigned int seed);

/** A scene as a volume of side^3 voxels with blur of up to 1 voxel and noise of up to a tenth of the contrast. */
struct SceneVolume
{
  itk::Image<float, 3>::Pointer         image;
  itk::Image<unsigned char, 3>::Pointer labels;
};

SceneVolume
SampleScene(unsigned int seed, unsigned int side);

/** How well the listed objects agree with the labels. */
struct ObjectAgreement
{
  std::vector<double> dice; ///< of each object with the label, or union of labels nested in each other, it fits best
  std::vector<double> diceOfLabel; ///< of each label with the object it fits best
};

ObjectAgreement
CompareObjects(const shapeton::HeatObjectList & list, const itk::Image<unsigned char, 3> * labels);

/** Dice of an object that counts as a whole one. */
constexpr double wholeObject = 0.85;

#endif
