#include "shapetonSliceView.h"

#include "shapetonPictureTestUtilities.h"
#include "shapetonSceneTestMeshes.h"

#include <set>
#include <stdexcept>

namespace
{
using MaskType = itk::Image<unsigned char, 3>;

constexpr shapeton::SlicePlane planes[] = { shapeton::SlicePlane::Axial,
                                            shapeton::SlicePlane::Coronal,
                                            shapeton::SlicePlane::Sagittal };

const shapeton::RGBColor black = shapeton::MakeColor(0, 0, 0);
const shapeton::RGBColor white = shapeton::MakeColor(255, 255, 255);

/** A ball of radius 11 mm in the middle of an oblique anisotropic image. */
struct Ball
{
  Ball() : mask(shapeton::ObliqueImage<MaskType>({ { 50, 40, 24 } }))
  {
    mask->TransformIndexToPhysicalPoint({ { 25, 20, 12 } }, center);
    for (itk::SizeValueType i = 0; i < mask->GetBufferedRegion().GetNumberOfPixels(); ++i)
    {
      MaskType::PointType point;
      mask->TransformIndexToPhysicalPoint(mask->ComputeIndex(static_cast<itk::OffsetValueType>(i)), point);
      mask->GetBufferPointer()[i] = point.EuclideanDistanceTo(center) < radius ? 1 : 0;
    }
  }

  shapeton::SliceView
  View(shapeton::SlicePlane plane) const
  {
    const itk::Index<3> middle{ { 25, 20, 12 } };
    return { mask, mask->GetBufferedRegion(), plane, middle[shapeton::AxesOf(mask, plane).through], 0.1 };
  }

  /** The distance of a pixel from the center, mm. */
  double
  DistanceOf(const shapeton::SliceView & view, int x, int y) const
  {
    MaskType::PointType point;
    mask->TransformContinuousIndexToPhysicalPoint(view.IndexOfPixel(x, y), point);
    return point.EuclideanDistanceTo(center);
  }

  static constexpr double radius = 11.0;
  MaskType::Pointer       mask;
  MaskType::PointType     center;
};

/** Checks that the drawn pixels form a ring around the middle of the picture between two distances from the center. */
void
ExpectRing(const shapeton::Picture * picture, const Ball & ball, const shapeton::SliceView & view, double tolerance)
{
  std::set<int> directions; // of 72
  const auto    middle = view.PixelOf(ball.mask->TransformPhysicalPointToContinuousIndex<double>(ball.center));
  for (int y = 0; y < static_cast<int>(view.GetHeight()); ++y)
  {
    for (int x = 0; x < static_cast<int>(view.GetWidth()); ++x)
    {
      if (shapeton::At(picture, x, y) == white)
      {
        ASSERT_NEAR(ball.DistanceOf(view, x, y), Ball::radius, tolerance) << x << " " << y;
        const double angle = std::atan2(y - middle[1], x - middle[0]) + shapeton::testPi;
        directions.insert(static_cast<int>(angle / (2 * shapeton::testPi) * 72) % 72);
      }
    }
  }
  EXPECT_EQ(directions.size(), 72U);
}
} // namespace

TEST(SliceView, PixelsAndPlacesAreInverse)
{
  const Ball ball;
  for (const auto plane : planes)
  {
    const shapeton::SliceView view = ball.View(plane);
    for (const auto & [x, y] : { std::pair(30, 40), std::pair(200, 111), std::pair(70, 170) })
    {
      const auto pixel = view.PixelOf(view.IndexOfPixel(x, y));
      EXPECT_NEAR(pixel[0], x, 1e-9);
      EXPECT_NEAR(pixel[1], y, 1e-9);
    }
    // One pixel to the right or up is 0.1 mm along the view directions.
    MaskType::PointType here;
    MaskType::PointType there;
    ball.mask->TransformContinuousIndexToPhysicalPoint(view.IndexOfPixel(100, 100), here);
    ball.mask->TransformContinuousIndexToPhysicalPoint(view.IndexOfPixel(140, 100), there);
    EXPECT_NEAR((there - here) * view.GetRight(), 4.0, 0.01);
    ball.mask->TransformContinuousIndexToPhysicalPoint(view.IndexOfPixel(100, 60), there);
    EXPECT_NEAR((there - here) * view.GetUp(), 4.0, 0.01);
  }
}

TEST(SliceView, OutlinesLieOnTheBorderOfAMask)
{
  const Ball ball;
  for (const auto plane : planes)
  {
    const shapeton::SliceView view = ball.View(plane);
    auto                      picture = shapeton::NewPicture(view.GetWidth(), view.GetHeight(), black);
    shapeton::DrawMaskOutline(
      picture, view, [&](const itk::Index<3> & index) { return ball.mask->GetPixel(index) == 1; }, white, 2.0);
    // The border is accurate to half a voxel diagonal in the slice.
    const auto & spacing = ball.mask->GetSpacing();
    const double diagonal = std::hypot(spacing[view.GetAxes().across], spacing[view.GetAxes().down]);
    ExpectRing(picture, ball, view, 0.5 * diagonal + 0.15);
    // Each drawn pixel is between a voxel inside and one outside.
    for (int y = 0; y < static_cast<int>(view.GetHeight()); ++y)
    {
      for (int x = 0; x < static_cast<int>(view.GetWidth()); ++x)
      {
        if (shapeton::At(picture, x, y) != white)
        {
          continue;
        }
        const auto    place = view.IndexOfPixel(x, y);
        std::set<int> labels;
        for (int corner = 0; corner < 4; ++corner)
        {
          itk::Index<3> index;
          for (unsigned int axis = 0; axis < 3; ++axis)
          {
            index[axis] = static_cast<itk::IndexValueType>(std::floor(place[axis] + 1e-6));
          }
          index[view.GetAxes().across] += corner & 1;
          index[view.GetAxes().down] += corner >> 1;
          labels.insert(ball.mask->GetPixel(index));
        }
        EXPECT_EQ(labels.size(), 2U) << x << " " << y;
      }
    }
  }
}

TEST(SliceView, AMaskAtTheBorderOfTheVolumeIsClosedThere)
{
  const Ball                ball;
  const shapeton::SliceView view = ball.View(shapeton::SlicePlane::Axial);
  auto                      picture = shapeton::NewPicture(view.GetWidth(), view.GetHeight(), black);
  shapeton::DrawMaskOutline(
    picture, view, [](const itk::Index<3> &) { return true; }, white, 2.0);
  for (unsigned int x = 5; x + 5 < view.GetWidth(); ++x)
  {
    ASSERT_EQ(shapeton::At(picture, static_cast<int>(x), 0), white);
    ASSERT_EQ(shapeton::At(picture, static_cast<int>(x), static_cast<int>(view.GetHeight()) - 1), white);
    ASSERT_EQ(shapeton::At(picture, static_cast<int>(x), static_cast<int>(view.GetHeight()) / 2), black);
  }
}

TEST(SliceView, ASliceCutsASphereInACircle)
{
  const Ball                  ball;
  const shapeton::SurfaceMesh sphere =
    shapeton::SphereMesh({ ball.center[0], ball.center[1], ball.center[2] }, Ball::radius, 120);
  for (const auto plane : planes)
  {
    const shapeton::SliceView view = ball.View(plane);
    auto                      picture = shapeton::NewPicture(view.GetWidth(), view.GetHeight(), black);
    shapeton::DrawSurfaceCut(picture, view, sphere, white, 2.0);
    ExpectRing(picture, ball, view, 0.16);
  }
}

TEST(SliceView, AFocusShowsItsVoxelsAlone)
{
  const Ball                ball;
  itk::ImageRegion<3>       focus({ { 10, 5, 3 } }, { { 12, 9, 7 } });
  const shapeton::SliceView view(ball.mask, focus, shapeton::SlicePlane::Axial, 6, 0.1);
  std::set<std::string>     seen;
  auto                      picture = shapeton::NewPicture(view.GetWidth(), view.GetHeight(), black);
  shapeton::ColorSlice(
    picture,
    view,
    [&](const itk::Index<3> & index) {
      EXPECT_TRUE(focus.IsInside(index));
      seen.insert(std::to_string(index[0]) + " " + std::to_string(index[1]) + " " + std::to_string(index[2]));
      return std::optional<shapeton::RGBColor>(white);
    },
    1.0);
  EXPECT_EQ(seen.size(), focus.GetSize(view.GetAxes().across) * focus.GetSize(view.GetAxes().down));
}

TEST(SliceView, RefusesWhatLiesOutside)
{
  const Ball                ball;
  const itk::ImageRegion<3> all = ball.mask->GetBufferedRegion();
  itk::ImageRegion<3>       beyond = all;
  beyond.SetIndex({ { 1, 0, 0 } });
  const auto make = [&](const itk::ImageRegion<3> & focus, itk::IndexValueType slice, double scale) {
    return shapeton::SliceView(ball.mask, focus, shapeton::SlicePlane::Axial, slice, scale);
  };
  EXPECT_THROW(make(beyond, 0, 1.0), std::invalid_argument);
  EXPECT_THROW(make(itk::ImageRegion<3>(), 0, 1.0), std::invalid_argument);
  EXPECT_THROW(make(all, -1, 1.0), std::invalid_argument);
  EXPECT_THROW(make(all, 50, 1.0), std::invalid_argument);
  EXPECT_THROW(make(all, 3, 0.0), std::invalid_argument);
}
