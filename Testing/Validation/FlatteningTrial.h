#ifndef FlatteningTrial_h
#define FlatteningTrial_h

#include "shapetonColonTube.h"
#include "shapetonConformalTube.h"
#include "shapetonFlatDistortion.h"
#include "shapetonSurfaceHandles.h"

/** A colon-like tube of the test generator with all that maps of it need. */
struct TubeCase
{
  explicit TubeCase(const testsurfaces::ColonTube & generated);

  shapeton::TubeMap
  Flatten(const Eigen::VectorXd & metric) const;
  /** Heat diffusion distances of the edges, t in mm^2. */
  Eigen::VectorXd
  Diffused(double t) const;
  shapeton::FlatDistortion
  Distortion(const shapeton::TubeMap & map, const Eigen::VectorXd & metric) const;

  testsurfaces::ColonTube       tube;
  shapeton::SurfaceConnectivity connectivity;
  shapeton::TubeEnds            ends;
  Eigen::VectorXd               lengths; ///< of the edges in space, mm
};

/** `span`: edges between the two faces that a handle joins. */
testsurfaces::ColonTube
GenerateTube(int faces, int handles, int seed, int span = 4, double length = 1500.0);

/** A tube of a million faces with handles that is simplified to 55,000. */
testsurfaces::ColonTube
GenerateDecimatedTube(int handles, int seed);

/** The handles that the generator made. */
std::vector<shapeton::SurfaceHandle>
TrueHandles(const testsurfaces::ColonTube & tube);

/** How many of the handles found lie within `distance` mm of a true one, each of which serves once. */
int
LocatedHandles(const std::vector<shapeton::SurfaceHandle> & found,
               std::vector<shapeton::SurfaceHandle>         truth,
               double                                       distance);

/** A tube with polyps: round bumps inwards around vertices far apart; the faces of each. */
struct PolypTube
{
  testsurfaces::ColonTube       tube;
  std::vector<std::vector<int>> polyps;
};
PolypTube
GenerateTubeWithPolyps(int faces, int seed, double length, double radius);

/** The ratio of the axes of the ellipse with the second moments of these faces on the map, at least 1. */
double
AspectRatioOnMap(const shapeton::SurfaceMesh & flat, const std::vector<int> & faces);

#endif
