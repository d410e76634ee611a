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

// ---- primitives: centered at the origin of the object's frame, long axis z ----

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

// ---- deformations, in the object's frame ----

/** The z axis becomes an arc of radius `arcRadius` around the point (arcRadius, 0, 0). Only the last deformation of an
 * object is a bend, and arcRadius > envelope[0]. */
struct Bend
{
  double arcRadius;
};
/** Each section is rotated about the z axis in proportion to z; rad per unit length. */
struct Twist
{
  double rate;
};
/** The surface is displaced outward by amplitude * sin(kx) sin(ky) sin(kz). */
struct Bumps
{
  double amplitude;
  double waveNumber;
};
using Deformation = std::variant<Bend, Twist, Bumps>;

/** One object of a scene, in the scene's unit of length. */
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

/** Half extents of the smallest box around the origin that contains the primitive. */
Vector
HalfExtent(const Primitive & primitive);

/** Half extents of a box around the origin that contains the object with its twists and bumps, before it is bent. */
Vector
Envelope(const Object & object);

/** Computes the envelope and the bounding sphere from all other members. */
void
UpdateBounds(Object & object);

/** Signed distance of a point to the surface, negative inside. Exact for undeformed boxes, spheres, cylinders, tori
 * and tubes (inside a sharp bend of a tube, a lower bound). For ellipsoids and deformed objects the sign is exact
 * and the value is the first-order distance f / |grad f|. */
double
SignedDistance(const Object & object, const Vector & point);
} // namespace shape
} // namespace shapeton

#endif
