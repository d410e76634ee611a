#include "shapetonFlatTestCt.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonExceptions.h"
#include "shapetonTestThreads.h"

namespace
{
using namespace flatcolon;
using shapeton::At;

int
Brightness(const shapeton::RGBColor & color)
{
  return color[0] + color[1] + color[2];
}

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
  EXPECT_LT(medium[0] - medium[2], 0.6 * (tissue[0] - tissue[2])) << "also next to gas";
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
  // More tissue begins 2 mm inside the surface. It must not hide the wall, which contains contrast medium.
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
  basetest::ExpectSameWithAnyThreads([&] { return basetest::BytesOf(colon.Paint(ct)); }, { 3 });
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
