#ifndef ShapeCollection_h
#define ShapeCollection_h

#include "shapetonShapeSearch.h"
#include "shapetonLabelShapes.h"

#include <string>
#include <vector>

/** A shape of a collection: the voxels of an image that are not 0. */
struct CollectedShape
{
  std::string                 name;
  shapeton::LabelMap::Pointer image;
};

/** Shapes of ShapePhantom's presets, no two of them alike. */
std::vector<CollectedShape>
PresetShapes();

/** Shapes of eight families with random proportions: ellipsoids, twisted boxes, bent capsules, rings, knotty tubes,
 * balls with bumps, bodies with limbs, boxes with rods, in images of 96^3 voxels. A seed is a shape. */
std::vector<CollectedShape>
GeneratedShapes(unsigned int firstSeed, int number);

/** Bones of two feet, the largest: what is above a threshold in CT, opened so that bones that touch come apart. */
std::vector<CollectedShape>
BonesOfFeet(const std::string & dataFolder, std::size_t number);

/** Organs of an abdomen of at least 1000 voxels, the largest. */
std::vector<CollectedShape>
Organs(const std::string & dataFolder, std::size_t number);

/** Copies of a shape, each of a kind. */
struct ShapeCopy
{
  std::string              kind;
  shapeton::ShapeSignature signature;
};

/** A shape and its copies as signatures. */
struct MeasuredShape
{
  std::string              name;
  shapeton::ShapeSignature original;
  std::vector<ShapeCopy>   copies;
};

/** The signatures of a shape and of copies of it: turned by 30 degrees, scaled by 0.5 and by 2 (in voxels of one size),
 * resampled (voxels 1.3 x 1.3 x 2.6 times as large, on slanted axes), noisy (a fifth of the voxels on either side of
 * the boundary change sides), and all of that together. `seed` decides axes and noise. Copies that are too small for a
 * signature are left out. */
MeasuredShape
Measure(const CollectedShape & shape, unsigned int seed);

/** Measure() for each of them, on all processors. */
std::vector<MeasuredShape>
Measure(const std::vector<CollectedShape> & shapes);

#endif
