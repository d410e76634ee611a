#ifndef shapetonShapeDistance_h
#define shapetonShapeDistance_h

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace shapeton
{
namespace shape
{
using Vector = std::array<double, 3>;

// ---- primitives: centered at the origin of the object coordinates, long axis z ----

struct Sphere
{
  double radius;
};
struct Ellipsoid
{
  Vector radii;
};
struct Box
{
  Vector halfSize;
};
struct Cylinder
{
  double radius;
  double halfLength;
};
/** A ring around the z axis. */
struct Torus
{
  double ringRadius;
  double tubeRadius;
};
/** All points within `radius` of a polyline. */
struct Tube
{
  std::vector<Vector> points;
  double              radius;
};
using Primitive = std::variant<Sphere, Ellipsoid, Box, Cylinder, Torus, Tube>;

// ---- deformations, in object coordinates ----

/** Bends the z axis into an arc of radius `arcRadius` around (arcRadius, 0, 0). Only the last deformation may be a
 * bend, and arcRadius > envelope[0]. */
struct Bend
{
  double arcRadius;
};
/** Rotates each section about the z axis in proportion to z; rad per unit length. */
struct Twist
{
  double rate;
};
/** Displaces the surface outward by amplitude * sin(kx) sin(ky) sin(kz). */
struct Bumps
{
  double amplitude;
  double waveNumber;
};
using Deformation = std::variant<Bend, Twist, Bumps>;

/** An object of a scene, in the length unit of the scene. */
struct Object
{
  std::string                          name;
  double                               intensity{ 1000.0 };
  unsigned char                        label{ 1 };
  Primitive                            primitive{ Sphere{ 1.0 } };
  std::vector<Deformation>             deformations;
  Vector                               center{ { 0.0, 0.0, 0.0 } };
  std::array<std::array<double, 3>, 3> rotation{ { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  Vector                               envelope{ { 0.0, 0.0, 0.0 } }; ///< half extents without the bend
  Vector                               boundingCenter{ { 0.0, 0.0, 0.0 } };
  double                               boundingRadius{ 0.0 };
};

/** Half extents of the bounding box of the primitive, centered at the origin. */
Vector
HalfExtent(const Primitive & primitive);

/** Half extents of a box around the origin that contains the object with twists and bumps, before bending. */
Vector
Envelope(const Object & object);

/** Computes the envelope and the bounding sphere from all other members. */
void
UpdateBounds(Object & object);

/** Signed distance of a point to the surface, negative inside. Exact for undeformed boxes, spheres, cylinders, tori and
 * tubes (a lower bound inside sharp bends of tubes). For ellipsoids and deformed objects, the sign is exact and the
 * value is the first-order distance f / |grad f|. */
double
SignedDistance(const Object & object, const Vector & point);
} // namespace shape
} // namespace shapeton

#endif
