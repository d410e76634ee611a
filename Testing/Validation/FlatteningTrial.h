#ifndef FlatteningTrial_h
#define FlatteningTrial_h

#include "shapetonColonTube.h"
#include "shapetonConformalTube.h"
#include "shapetonFlatDistortion.h"
#include "shapetonSurfaceHandles.h"

/** Colon-like tube of the test generator with the data needed for its maps. */
struct TubeCase
{
  explicit TubeCase(const testsurfaces::ColonTube & generated);

  shapeton::TubeMap
  Flatten(const Eigen::VectorXd & metric) const;
  /** Returns the heat diffusion distances of the edges, t in mm^2. */
  Eigen::VectorXd
  Diffused(double t) const;
  shapeton::FlatDistortion
  Distortion(const shapeton::TubeMap & map, const Eigen::VectorXd & metric) const;

  testsurfaces::ColonTube       tube;
  shapeton::SurfaceConnectivity connectivity;
  shapeton::TubeEnds            ends;
  Eigen::VectorXd               lengths; ///< Euclidean edge lengths (mm)
};

/** `span` is the number of edges between the two faces joined by a handle. */
testsurfaces::ColonTube
GenerateTube(int faces, int handles, int seed, int span = 4, double length = 1500.0);

/** Tube of a million faces with handles, simplified to 55,000 faces. */
testsurfaces::ColonTube
GenerateDecimatedTube(int handles, int seed);

/** Handles created by the generator. */
std::vector<shapeton::SurfaceHandle>
TrueHandles(const testsurfaces::ColonTube & tube);

/** Number of detected handles within `distance` mm of a true one; each true handle is matched once. */
int
LocatedHandles(const std::vector<shapeton::SurfaceHandle> & found,
               std::vector<shapeton::SurfaceHandle>         truth,
               double                                       distance);

/** Tube with polyps (round inward bumps around vertices far apart), and the faces of each polyp. */
struct PolypTube
{
  testsurfaces::ColonTube       tube;
  std::vector<std::vector<int>> polyps;
};
PolypTube
GenerateTubeWithPolyps(int faces, int seed, double length, double radius);

/** Axis ratio (at least 1) of the ellipse with the second moments of these faces on the map. */
double
AspectRatioOnMap(const shapeton::SurfaceMesh & flat, const std::vector<int> & faces);

#endif
