#ifndef shapetonTestColon_h
#define shapetonTestColon_h

#include "shapetonColonPictures.h"
#include "shapetonSceneTestMeshes.h"

#include <array>

namespace shapeton
{
/** An arch in a coronal plane: half a circle of 60 mm radius from the patient's left over the head side to the right.
 * The tube has a radius of 10 mm, is narrow at 60 % of its length, and has a gap from 30 to 36 %, bridged by a tube of
 * 2 mm. Fluid fills y > 3 mm. The image axes run along the patient's axes order[i], reversed where `reversed` is
 * set. */
class TestColon
{
public:
  static constexpr double bend = 60.0;
  static constexpr double length = testPi * bend;

  explicit TestColon(std::array<unsigned int, 3> order = { { 0, 1, 2 } },
                     std::array<bool, 3>         isReversed = { { false, false, false } })
  {
    this->MakeGrid(order, isReversed);
    this->FillVolumes();
    this->MakeCenterline();
    this->MakeWall();
  }

  ColonParts
  Parts() const
  {
    return { ct, lumen, &centerline, &wall };
  }

  static bool
  IsGap(double share)
  {
    return share > 0.3 && share < 0.36;
  }

  static double
  RadiusAt(double share)
  {
    const double off = (share - 0.6) / 0.03;
    return IsGap(share) ? 2.0 : 10.0 - 6.0 * std::exp(-off * off);
  }

  itk::Image<float, 3>::Pointer         ct;
  itk::Image<unsigned char, 3>::Pointer lumen;
  CurveSet                              centerline;
  SurfaceMesh                           wall;

private:
  template <typename TImage>
  static typename TImage::Pointer
  NewImage(const std::array<unsigned int, 3> & order, const std::array<bool, 3> & isReversed)
  {
    const double                   spacing[3] = { 1.5, 2.0, 1.25 };
    const double                   extent[3] = { 180.0, 60.0, 110.0 };
    const double                   corner[3] = { -90.0, -30.0, -20.0 };
    auto                           image = TImage::New();
    typename TImage::SizeType      size;
    typename TImage::SpacingType   steps;
    typename TImage::PointType     origin;
    typename TImage::DirectionType direction;
    direction.Fill(0.0);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const unsigned int patient = order[axis];
      steps[axis] = spacing[patient];
      size[axis] = static_cast<itk::SizeValueType>(extent[patient] / spacing[patient] + 0.5);
      direction[patient][axis] = isReversed[patient] ? -1.0 : 1.0;
      origin[patient] =
        corner[patient] + spacing[patient] * (isReversed[patient] ? static_cast<double>(size[axis]) - 0.5 : 0.5);
    }
    image->SetRegions(size);
    image->SetSpacing(steps);
    image->SetDirection(direction);
    image->SetOrigin(origin);
    image->Allocate();
    return image;
  }

  void
  MakeGrid(const std::array<unsigned int, 3> & order, const std::array<bool, 3> & isReversed)
  {
    ct = NewImage<itk::Image<float, 3>>(order, isReversed);
    lumen = NewImage<itk::Image<unsigned char, 3>>(order, isReversed);
  }

  void
  FillVolumes()
  {
    for (itk::SizeValueType i = 0; i < lumen->GetBufferedRegion().GetNumberOfPixels(); ++i)
    {
      itk::Image<float, 3>::PointType p;
      lumen->TransformIndexToPhysicalPoint(lumen->ComputeIndex(static_cast<itk::OffsetValueType>(i)), p);
      const double  share = std::atan2(std::max(p[2], 0.0), p[0]) / testPi;
      const double  off = std::hypot(std::hypot(p[0], p[2]) - bend, p[1]);
      const bool    isLumen = p[2] >= 0.0 && !IsGap(share) && off < RadiusAt(share);
      const bool    isFluid = isLumen && p[1] > 3.0;
      unsigned char label = 0;
      label = isFluid ? 2 : isLumen ? 1 : 0;
      lumen->GetBufferPointer()[i] = label;
      const bool isBody = std::hypot(p[0] / 88.0, p[1] / 28.0) < 1.0;
      ct->GetBufferPointer()[i] = label == 1 ? -980.0F : label == 2 ? 600.0F : isBody ? 40.0F : -1000.0F;
    }
  }

  static Eigen::RowVector3d
  PointAt(double share, double off, double angle)
  {
    const double across = bend + off * std::cos(angle);
    return { across * std::cos(testPi * share), off * std::sin(angle), across * std::sin(testPi * share) };
  }

  void
  MakeCenterline()
  {
    constexpr int points = 190;
    centerline.V.resize(points, 3);
    centerline.curves.resize(1);
    SurfaceArray distance{ "arcLength", SurfaceArray::ValueMatrix(points, 1), false };
    SurfaceArray radius{ "radius", SurfaceArray::ValueMatrix(points, 1), false };
    SurfaceArray gap{ "gap", SurfaceArray::ValueMatrix(points, 1), true };
    for (int i = 0; i < points; ++i)
    {
      const double share = i / (points - 1.0);
      centerline.V.row(i) = PointAt(share, 0.0, 0.0);
      centerline.curves[0].push_back(i);
      distance.values(i, 0) = share * length;
      radius.values(i, 0) = RadiusAt(share);
      gap.values(i, 0) = IsGap(share) ? 1.0 : 0.0;
    }
    centerline.pointArrays = { distance, radius, gap };
  }

  void
  MakeWall()
  {
    constexpr int along = 190;
    constexpr int around = 32;
    wall = ParametricMesh(around, along, [](double u, double v) { return PointAt(v, RadiusAt(v), 2.0 * testPi * u); });
    SurfaceArray bridged{ "bridged", SurfaceArray::ValueMatrix(wall.F.rows(), 1), true };
    for (Eigen::Index face = 0; face < wall.F.rows(); ++face)
    {
      bridged.values(face, 0) = IsGap((static_cast<double>(face) / (2 * around) + 0.5) / along) ? 1.0 : 0.0;
    }
    wall.cellArrays = { bridged };
  }
};

inline std::vector<ColonSegment>
TestSegments()
{
  const double length = TestColon::length;
  return { { "rectum", 0.0, 0.1 * length },
           { "sigmoid", 0.1 * length, 0.45 * length },
           { "ascending", 0.45 * length, 0.93 * length },
           { "cecum", 0.93 * length, length } };
}
} // namespace shapeton

#endif
