#include "shapetonFlatColonStrip.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonFlatTestColon.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonExceptions.h"

#include <functional>

namespace
{
using namespace flatcolon;
using shapeton::At;
using shapeton::FlatColonGrid;
using Ct = itk::Image<float, 3>;

/** What the wall's CT shows: gas inside of this radius, soft tissue outside, a boundary of about 1 mm. */
float
HuAt(const Eigen::Vector3d & point, double (*radiusAt)(double, double))
{
  const double r = std::hypot(point.x(), point.y());
  const double angle = std::atan2(point.y(), point.x());
  const double share = std::clamp((r - radiusAt(point.z(), angle)) / 1.2 + 0.5, 0.0, 1.0);
  return static_cast<float>(-1000.0 + 1040.0 * share);
}

/** A CT of the colon with these axes. */
Ct::Pointer
MakeCt(const Eigen::Matrix3d &                               axes,
       const Eigen::Vector3d &                               spacing,
       const std::function<float(const Eigen::Vector3d &)> & huAt)
{
  constexpr double      reach = 28.0;
  const Eigen::Vector3d centre(0.0, 0.0, 0.5 * length);
  const Eigen::Vector3d half = axes.transpose().cwiseAbs() * Eigen::Vector3d(reach, reach, 0.5 * length + 8.0);
  Ct::SizeType          size;
  Ct::SpacingType       spacings;
  Ct::DirectionType     direction;
  for (int k = 0; k < 3; ++k)
  {
    size[k] = static_cast<itk::SizeValueType>(2.0 * half[k] / spacing[k]) + 2;
    spacings[k] = spacing[k];
    for (int row = 0; row < 3; ++row)
    {
      direction[row][k] = axes(row, k);
    }
  }
  const Eigen::Vector3d corner = centre - axes * half;
  const auto            image = Ct::New();
  image->SetRegions(size);
  image->SetSpacing(spacings);
  image->SetDirection(direction);
  image->SetOrigin(corner.data());
  image->Allocate();
  float * voxel = image->GetBufferPointer();
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        *voxel++ = huAt(corner + axes * Eigen::Vector3d(x * spacing[0], y * spacing[1], z * spacing[2]));
      }
    }
  }
  return image;
}

Ct::Pointer
MakeStraightCt(const std::function<float(const Eigen::Vector3d &)> & huAt)
{
  return MakeCt(Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.8, 0.8, 1.0), huAt);
}

double
SmoothTube(double, double)
{
  return radius;
}

int
Brightness(const shapeton::RGBColor & color)
{
  return color[0] + color[1] + color[2];
}

struct Colon
{
  explicit Colon(double (*radiusAt)(double, double), double pixelSize = 1.0)
    : grid(Wall(radiusAt), { pixelSize, 0.0, 0.0 }), axis(MakeFlatColonAxis(grid))
  {}
  shapeton::Picture::Pointer
  Paint(const Ct * ct, const shapeton::FlatVolumeOptions & options = {}) const
  {
    return PaintFlatVolume(grid, axis, ct, options);
  }
  FlatColonGrid           grid;
  shapeton::FlatColonAxis axis;
};
} // namespace

TEST(FlatVolumePicture, ShowsWhatTheCtHoldsAndTheSurfaceDoesNot)
{
  const Colon colon(SmoothTube); // a smooth surface in a CT with folds and a polyp
  const auto  smooth = colon.Paint(MakeStraightCt([](const Eigen::Vector3d & p) { return HuAt(p, SmoothTube); }));
  shapeton::FlatVolumeOptions deep;
  deep.depthOfLumen = 6.0;
  const auto bumpy = colon.Paint(MakeStraightCt([](const Eigen::Vector3d & p) { return HuAt(p, RadiusAt); }), deep);
  const shapeton::FlatPixel middle =
    shapeton::FlatColonLocator(colon.grid).Find(PointAt(polypU, polypAngle, radius)).pixel;
  const int level = Brightness(At(smooth, middle.column, middle.row));
  EXPECT_NEAR(Brightness(At(smooth, middle.column + 3, middle.row)), level, 25);
  EXPECT_GT(Brightness(At(bumpy, middle.column - 3, middle.row)), level + 25) << "the lit side of the polyp";
  EXPECT_LT(Brightness(At(bumpy, middle.column + 3, middle.row)), level - 60) << "its shadow";
}

TEST(FlatVolumePicture, ContrastMediumIsWhite)
{
  const Colon              colon(SmoothTube);
  const auto               picture = colon.Paint(MakeStraightCt([](const Eigen::Vector3d & p) {
    const float hu = HuAt(p, SmoothTube);
    return hu > -300.0F && p.z() > 80.0 && p.z() < 100.0 ? 600.0F : hu;
  }));
  const shapeton::RGBColor tissue = At(picture, 50, 30);
  const shapeton::RGBColor medium = At(picture, 90, 30);
  EXPECT_GT(tissue[0], tissue[2] + 50);
  EXPECT_LT(medium[0] - medium[2], 0.6 * (tissue[0] - tissue[2])) << "also where it borders on gas";
}

TEST(FlatVolumePicture, ObliqueVolumesShowTheSame)
{
  const Colon     colon(RadiusAt);
  const auto      huAt = [](const Eigen::Vector3d & p) { return HuAt(p, RadiusAt); };
  const auto      straight = colon.Paint(MakeStraightCt(huAt));
  Eigen::Matrix3d axes =
    (Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
  axes.col(1) *= -1.0; // left-handed, as most NIfTI files are
  const auto oblique = colon.Paint(MakeCt(axes, Eigen::Vector3d(1.2, 1.0, 1.3), huAt));
  double     sum = 0.0;
  const auto number = straight->GetBufferedRegion().GetNumberOfPixels();
  for (itk::SizeValueType i = 0; i < number; ++i)
  {
    sum += std::abs(Brightness(straight->GetBufferPointer()[i]) - Brightness(oblique->GetBufferPointer()[i]));
  }
  EXPECT_LT(sum / number, 12.0) << "of 765";
}

TEST(FlatVolumePicture, RaysStopAtTheOppositeWall)
{
  // Tissue begins again 2 mm inside of the surface: it must not hide the wall, which holds contrast medium.
  const Colon              colon(SmoothTube);
  const auto               picture = colon.Paint(MakeStraightCt([](const Eigen::Vector3d & p) {
    const double r = std::hypot(p.x(), p.y());
    return r > radius ? 600.0F : r < radius - 2.5 ? 40.0F : -1000.0F;
  }));
  const shapeton::RGBColor color = At(picture, 90, 30);
  EXPECT_LT(std::abs(color[0] - color[2]), 50) << "white, not pink";
}

TEST(FlatVolumePicture, ThreadsDoNotMatter)
{
  const Colon colon(RadiusAt);
  const auto  ct = MakeStraightCt([](const Eigen::Vector3d & p) { return HuAt(p, RadiusAt); });
  std::vector<shapeton::Picture::Pointer> pictures;
  for (const unsigned int threads : { 1U, 3U })
  {
    const shapeton::ThreadNumber number(threads);
    pictures.push_back(colon.Paint(ct));
  }
  EXPECT_EQ(shapeton::GreatestDifference(pictures[0], pictures[1]), 0);
}

TEST(FlatVolumePicture, RefusesAnotherPatientsVolume)
{
  const Colon                 colon(SmoothTube);
  const auto                  ct = MakeStraightCt([](const Eigen::Vector3d & p) { return HuAt(p, SmoothTube); });
  shapeton::FlatVolumeOptions options;
  options.gas = 0.0;
  EXPECT_THROW(colon.Paint(ct, options), shapeton::ParameterError);
  Ct::PointType origin = ct->GetOrigin();
  origin[2] += 60.0;
  ct->SetOrigin(origin);
  EXPECT_THROW(colon.Paint(ct), shapeton::InputError);
}

TEST(FlatVolumePicture, FlatVolumeBaseline)
{
  const Colon colon(RadiusAt, 0.6);
  const auto  ct = MakeStraightCt([](const Eigen::Vector3d & p) { return HuAt(p, RadiusAt); });
  shapeton::ExpectBaseline(colon.Paint(ct), "shapetonFlatVolume.png");
}
