#ifndef shapetonCecalScene_h
#define shapetonCecalScene_h

#include "shapetonIleocecalValve.h"
#include "shapetonLumenShapes.h"

#include <Eigen/Geometry>

#include <cmath>

/** The end of a colon: a tube with a radius of 24 mm along z that ends in a hemisphere at 200 mm, with added
 * structures. */
namespace cecalscene
{
constexpr double radius = 24.0, end = 200.0;
/** Base of the valve: half an ellipsoid on the wall, 24 mm wide around the tube, 18 mm long along it, and 11 mm high.
 */
const Eigen::Vector3d valveBase(radius, 0.0, 130.0);

struct Scene
{
  bool   hasValve{ true };
  bool   hasFold{ false };
  bool   hasTwoLips{ false }; ///< the valve: two lips of 9 mm height on both sides of a slit
  bool   hasPolyp{ false };   ///< half a ball of soft tissue with a radius of 9 mm, 20 mm nearer to the end
  double ileumLength{ 0.0 };
  double ileumRadius{ 5.0 };
  /** HU inside the valve. */
  float core{ -80.0F };
  /** Transform of the patient: rotation of the tube, or reflection at x = 0. */
  Eigen::Matrix3d turn{ Eigen::Matrix3d::Identity() };
};

inline bool
IsTube(const Eigen::Vector3d & p)
{
  return p.z() <= end - radius ? p.head<2>().norm() < radius
                               : (p - Eigen::Vector3d(0, 0, end - radius)).norm() < radius;
}

/** Below 1 inside. */
inline double
InValve(const Scene & scene, const Eigen::Vector3d & p)
{
  const Eigen::Vector3d q = p - valveBase;
  const Eigen::Vector3d lip(q.x(), q.y(), std::abs(q.z()) - 6.0);
  return scene.hasTwoLips ? lip.cwiseQuotient(Eigen::Vector3d(9.0, 9.0, 4.5)).squaredNorm()
                          : q.cwiseQuotient(Eigen::Vector3d(11.0, 12.0, 9.0)).squaredNorm();
}

inline bool
IsPolyp(const Scene & scene, const Eigen::Vector3d & p)
{
  return scene.hasPolyp && (p - Eigen::Vector3d(-radius, 0.0, 150.0)).norm() < 9.0;
}

inline bool
IsIleum(const Scene & scene, const Eigen::Vector3d & p)
{
  return scene.ileumLength > 0.0 && p.x() > 0.0 && p.x() < radius + scene.ileumLength &&
         (p.tail<2>() - Eigen::Vector2d(0.0, 145.0)).norm() < scene.ileumRadius;
}

inline bool
IsLumen(const Scene & scene, const Eigen::Vector3d & p)
{
  const bool isFold =
    scene.hasFold && std::abs(p.z() - 90.0) < 1.5 && p.head<2>().norm() > radius - 10.0 && p.y() > 0.0;
  const bool isValve = scene.hasValve && InValve(scene, p) < 1.0;
  return (IsTube(p) && !isFold && !isValve && !IsPolyp(scene, p)) || IsIleum(scene, p);
}

struct Images
{
  shapeton::LumenMask::Pointer  lumen{ shapeton::LumenMask::New() };
  itk::Image<float, 3>::Pointer ct{ itk::Image<float, 3>::New() };
};

/** Creates images with this spacing and direction matrix `axes`. */
inline Images
Draw(const Scene &           scene,
     const Eigen::Vector3d & spacing = Eigen::Vector3d::Constant(1.5),
     const Eigen::Matrix3d & axes = Eigen::Matrix3d::Identity())
{
  const Eigen::Vector3d middle = scene.turn * Eigen::Vector3d(20.0, 0.0, 110.0);
  const Eigen::Vector3d sides = axes.transpose().cwiseAbs() * scene.turn.cwiseAbs() * Eigen::Vector3d(170, 90, 230);
  const Eigen::Vector3d first = middle - 0.5 * axes * sides;
  itk::Size<3>          size;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = static_cast<itk::SizeValueType>(sides[i] / spacing[i]);
  }
  Images images;
  images.lumen = basetest::NewImageInFrame<shapeton::LumenMask>(size, spacing, first, axes);
  images.ct = basetest::NewImageInFrame<itk::Image<float, 3>>(size, spacing, first, axes);
  basetest::ForVoxels(images.lumen, [&](const auto & index, const auto & point) {
    const Eigen::Vector3d p = scene.turn.transpose() * basetest::ToEigen(point);
    const bool            isLumen = IsLumen(scene, p);
    images.lumen->SetPixel(index, isLumen ? 1 : 0);
    images.ct->SetPixel(index, isLumen ? -950.0F : InValve(scene, p) < 0.6 ? scene.core : 40.0F);
  });
  return images;
}

inline shapeton::CurveSet
Line(const Scene & scene)
{
  lumenshapes::Points points;
  for (int z = 5; z < static_cast<int>(end) - 4; ++z)
  {
    points.emplace_back(scene.turn * Eigen::Vector3d(0.0, 0.0, z));
  }
  shapeton::CurveSet line = lumenshapes::Centerline(points);
  line.pointArrays.resize(1); // arcLength
  line.pointArrays[0].values.array() += 1000.0;
  return line;
}

inline shapeton::ValveSearch
Search(const Scene & scene, const Images & images, bool withCt = true)
{
  return shapeton::FindIleocecalValve(images.lumen, withCt ? images.ct.GetPointer() : nullptr, Line(scene));
}
} // namespace cecalscene

#endif
