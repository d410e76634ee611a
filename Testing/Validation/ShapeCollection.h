#ifndef ShapeCollection_h
#define ShapeCollection_h

#include "shapetonShapeSearch.h"
#include "shapetonLabelShapes.h"

#include <string>
#include <vector>

/** Shape of a collection: the nonzero voxels of an image. */
struct CollectedShape
{
  std::string                 name;
  shapeton::LabelMap::Pointer image;
};

/** Distinct shapes of ShapePhantom's presets. */
std::vector<CollectedShape>
PresetShapes();

/** Shapes of eight families with random proportions in images of 96^3 voxels: ellipsoids, twisted boxes, bent capsules,
 * rings, knotty tubes, balls with bumps, bodies with limbs, boxes with rods. One shape per seed. */
std::vector<CollectedShape>
GeneratedShapes(unsigned int firstSeed, int number);

/** Largest bones of two feet: thresholded CT, opened to separate touching bones. */
std::vector<CollectedShape>
BonesOfFeet(const std::string & dataFolder, std::size_t number);

/** Organs of an abdomen with at least 1000 voxels, largest first. */
std::vector<CollectedShape>
Organs(const std::string & dataFolder, std::size_t number);

/** Kinds of copies of a shape. */
struct ShapeCopy
{
  std::string              kind;
  shapeton::ShapeSignature signature;
};

/** Signatures of a shape and its copies. */
struct MeasuredShape
{
  std::string              name;
  shapeton::ShapeSignature original;
  std::vector<ShapeCopy>   copies;
};

/** Signatures of a shape and its copies: rotated by 30 degrees, scaled by 0.5 and by 2 (in isotropic voxels), resampled
 * (voxels 1.3 x 1.3 x 2.6 times as large, on slanted axes), noisy (a fifth of the voxels on either side of the boundary
 * flipped), and all of these combined. `seed` determines axes and noise. Copies that are too small for a signature are
 * omitted. */
MeasuredShape
Measure(const CollectedShape & shape, unsigned int seed);

/** Calls Measure() for each shape, on all processors. */
std::vector<MeasuredShape>
Measure(const std::vector<CollectedShape> & shapes);

#endif
