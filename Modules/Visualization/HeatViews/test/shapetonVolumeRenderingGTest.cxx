#include "shapetonVolumeRendering.h"
#include "shapetonPatientOrientation.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonTestThreads.h"
#include "shapetonTestImages.h"

#include "itkMultiThreaderBase.h"

#include <stdexcept>

namespace
{
using ImageType = itk::Image<float, 3>;
using PointType = shapeton::PatientView::PointType;

constexpr float redHeat = 0.1F;
constexpr float greenHeat = 0.2F;
constexpr float blueHeat = 0.4F;

const char * const threeLines = "0.05-0.15:#ff0000:1,0.15-0.25:#00ff00:1,0.35-0.45:#0000ff:1";

PointType
MakePoint(double x, double y, double z)
{
  PointType point;
  point[0] = x;
  point[1] = y;
  point[2] = z;
  return point;
}

/** An oblique, anisotropic grid around the point (10, -20, 30). */
ImageType::Pointer
MakeObliqueGrid()
{
  const itk::Matrix<double, 3, 3> direction = basetest::Rotation(2, 0.35) * basetest::Rotation(0, -0.5);
  const auto   image = basetest::NewImage<ImageType>({ { 100, 66, 40 } }, { { 1.0, 1.5, 2.5 } }, {}, direction);
  const double toMiddle[3] = { 49.5, 48.75, 48.75 };
  image->SetOrigin(MakePoint(10, -20, 30) - direction * itk::Vector<double, 3>(toMiddle));
  return image;
}

void
FillBall(ImageType * image, const PointType & center, double radius, float heat)
{
  basetest::ForVoxels(image, [&](const auto & index, const PointType & point) {
    if (point.EuclideanDistanceTo(center) <= radius)
    {
      image->SetPixel(index, heat);
    }
  });
}

const PointType redCenter = MakePoint(-10, -25, 38);
const PointType greenCenter = MakePoint(28, -15, 36);
const PointType blueCenter = MakePoint(12, -12, 14);

/** Three balls of 7 mm: to the patient's right and up, to the left and up, and down. */
ImageType::Pointer
MakePhantom()
{
  auto image = MakeObliqueGrid();
  FillBall(image, redCenter, 7.0, redHeat);
  FillBall(image, greenCenter, 7.0, greenHeat);
  FillBall(image, blueCenter, 7.0, blueHeat);
  return image;
}

/** Mean position of all pixels whose channel is much brighter than the others; the third value is their count. */
itk::Vector<double, 3>
MeanPlaceOf(const shapeton::Picture * picture, unsigned int channel)
{
  itk::Vector<double, 3> mean(0.0);
  const auto             size = picture->GetBufferedRegion().GetSize();
  for (unsigned int y = 0; y < size[1]; ++y)
  {
    for (unsigned int x = 0; x < size[0]; ++x)
    {
      const shapeton::RGBColor color = shapeton::At(picture, x, y);
      if (color[channel] > 60 && color[channel] > 2 * color[(channel + 1) % 3] &&
          color[channel] > 2 * color[(channel + 2) % 3])
      {
        mean[0] += x;
        mean[1] += y;
        mean[2] += 1.0;
      }
    }
  }
  mean[0] /= mean[2];
  mean[1] /= mean[2];
  return mean;
}
} // namespace

struct NamedView
{
  double azimuth;
  double elevation;
};

void
PrintTo(const NamedView & view, std::ostream * stream)
{
  *stream << view.azimuth << ", " << view.elevation;
}

class VolumeRenderingFrom : public testing::TestWithParam<NamedView>
{};

TEST_P(VolumeRenderingFrom, EachObjectIsSeenAtItsProjectedPlaceAndSize)
{
  const auto                       heat = MakePhantom();
  shapeton::VolumeRenderingOptions options;
  options.azimuth = GetParam().azimuth;
  options.elevation = GetParam().elevation;
  options.width = 400;
  options.height = 320;
  options.annotations = false;
  const shapeton::PatientView view = shapeton::ViewOfVolume(heat, options);
  const auto      picture = shapeton::RenderVolume(heat, shapeton::ShapeTransferFunction::Parse(threeLines), options);
  const PointType centers[3] = { redCenter, greenCenter, blueCenter };
  const double    radius = 7.0 / view.GetMillimetersPerPixel();
  for (unsigned int channel = 0; channel < 3; ++channel)
  {
    const auto seen = MeanPlaceOf(picture, channel);
    const auto expected = view.Project(centers[channel]);
    EXPECT_NEAR(seen[0], expected[0], 1.5) << "channel " << channel;
    EXPECT_NEAR(seen[1], expected[1], 1.5) << "channel " << channel;
    EXPECT_NEAR(std::sqrt(seen[2] / 3.14159265), radius, 0.08 * radius) << "channel " << channel;
  }
}

INSTANTIATE_TEST_SUITE_P(Views,
                         VolumeRenderingFrom,
                         testing::Values(NamedView{ 0, 0 },
                                         NamedView{ 35, 20 },
                                         NamedView{ 180, 0 },
                                         NamedView{ 0, 90 },
                                         NamedView{ -60, -35 }));

TEST(VolumeRendering, TheDefaultViewIsFromTheFront)
{
  const auto heat = MakePhantom();
  const auto picture = shapeton::RenderVolume(heat, shapeton::ShapeTransferFunction::Parse(threeLines));
  const auto red = MeanPlaceOf(picture, 0);
  const auto green = MeanPlaceOf(picture, 1);
  const auto blue = MeanPlaceOf(picture, 2);
  EXPECT_LT(red[0], green[0]); // the patient's right is at the left
  EXPECT_GT(blue[1], red[1]);  // the feet are below
  EXPECT_GT(blue[1], green[1]);
}

TEST(VolumeRendering, WhatIsNearerHidesWhatIsBehind)
{
  auto heat = MakeObliqueGrid();
  FillBall(heat, MakePoint(10, -35, 30), 8.0, redHeat);
  FillBall(heat, MakePoint(10, -5, 30), 4.0, greenHeat);
  shapeton::VolumeRenderingOptions options;
  options.annotations = false;
  const auto function = shapeton::ShapeTransferFunction::Parse(threeLines);
  const auto front = shapeton::RenderVolume(heat, function, options);
  EXPECT_GT(MeanPlaceOf(front, 0)[2], 500.0);
  EXPECT_EQ(MeanPlaceOf(front, 1)[2], 0.0);
  options.azimuth = 180.0;
  const auto back = shapeton::RenderVolume(heat, function, options);
  EXPECT_GT(MeanPlaceOf(back, 0)[2], 500.0);
  EXPECT_GT(MeanPlaceOf(back, 1)[2], 200.0);
}

TEST(VolumeRendering, OneLineAloneShowsItsObjectsOnly)
{
  const auto heat = MakePhantom();
  const auto all = shapeton::ShapeTransferFunction::Parse(threeLines);
  const auto picture = shapeton::RenderVolume(heat, all.OnlyLine(1), {});
  EXPECT_EQ(MeanPlaceOf(picture, 0)[2], 0.0);
  EXPECT_GT(MeanPlaceOf(picture, 1)[2], 500.0);
  EXPECT_EQ(MeanPlaceOf(picture, 2)[2], 0.0);
}

TEST(VolumeRendering, NoOtherObjectsColorAppearsBetweenAnObjectAndTheBackground)
{
  // Blue has the highest heat; interpolated heat would pass through green and red on its surface.
  auto heat = MakeObliqueGrid();
  FillBall(heat, blueCenter, 9.0, blueHeat);
  const auto picture = shapeton::RenderVolume(heat, shapeton::ShapeTransferFunction::Parse(threeLines), {});
  EXPECT_EQ(MeanPlaceOf(picture, 0)[2], 0.0);
  EXPECT_EQ(MeanPlaceOf(picture, 1)[2], 0.0);
  EXPECT_GT(MeanPlaceOf(picture, 2)[2], 500.0);
}

TEST(VolumeRendering, TransparentObjectsShowWhatIsInside)
{
  auto heat = MakeObliqueGrid();
  FillBall(heat, MakePoint(10, -20, 30), 18.0, redHeat);
  FillBall(heat, MakePoint(10, -20, 30), 7.0, greenHeat);
  shapeton::VolumeRenderingOptions options;
  const auto                       clear = shapeton::RenderVolume(
    heat, shapeton::ShapeTransferFunction::Parse("0.05-0.15:red:0.02,0.15-0.25:lime:1"), options);
  const auto opaque =
    shapeton::RenderVolume(heat, shapeton::ShapeTransferFunction::Parse("0.05-0.15:red:1,0.15-0.25:lime:1"), options);
  const shapeton::RGBColor seen = shapeton::At(clear, 399, 299);
  EXPECT_GT(seen[1], 120);
  EXPECT_GT(seen[1], 2 * seen[0]);
  EXPECT_LT(shapeton::At(opaque, 399, 299)[1], 60);
}

TEST(VolumeRendering, TheStorageOfTheVolumeDoesNotMatter)
{
  // The same voxels stored with the first axis reversed, and with a region that does not start at 0.
  const auto image = MakePhantom();
  auto       other = ImageType::New();
  auto       region = image->GetBufferedRegion();
  auto       direction = image->GetDirection();
  PointType  origin;
  image->TransformIndexToPhysicalPoint({ { 99, 0, 0 } }, origin);
  for (unsigned int row = 0; row < 3; ++row)
  {
    direction[row][0] = -direction[row][0];
  }
  other->SetDirection(direction);
  other->SetSpacing(image->GetSpacing());
  other->SetRegions(region);
  other->SetOrigin(origin);
  other->Allocate();
  for (itk::SizeValueType i = 0; i < region.GetNumberOfPixels(); ++i)
  {
    itk::Index<3> index = image->ComputeIndex(static_cast<itk::OffsetValueType>(i));
    index[0] = 99 - index[0];
    other->SetPixel(index, image->GetBufferPointer()[i]);
  }
  auto          shifted = ImageType::New();
  itk::Index<3> start{ { -7, 12, 3 } };
  shifted->CopyInformation(image);
  shifted->SetRegions(ImageType::RegionType(start, region.GetSize()));
  shifted->Allocate();
  std::copy_n(image->GetBufferPointer(), region.GetNumberOfPixels(), shifted->GetBufferPointer());
  itk::Vector<double, 3> offset;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    offset[axis] = start[axis] * image->GetSpacing()[axis];
  }
  shifted->SetOrigin(image->GetOrigin() - image->GetDirection() * offset);

  const auto function = shapeton::ShapeTransferFunction::Parse(threeLines);
  const auto picture = shapeton::RenderVolume(image, function, {});
  // Rounding may move a sample that is halfway between two voxels.
  const auto countDifferent = [&](const shapeton::Picture * with) {
    int different = 0;
    for (itk::SizeValueType i = 0; i < 800 * 600; ++i)
    {
      const auto & a = picture->GetBufferPointer()[i];
      const auto & b = with->GetBufferPointer()[i];
      different += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) > 6 ? 1 : 0;
    }
    return different;
  };
  EXPECT_LT(countDifferent(shapeton::RenderVolume(other, function, {})), 20);
  EXPECT_LT(countDifferent(shapeton::RenderVolume(shifted, function, {})), 20);
}

TEST(VolumeRendering, TheNumberOfThreadsDoesNotMatter)
{
  const auto                       heat = MakePhantom();
  shapeton::VolumeRenderingOptions options;
  options.azimuth = 20.0;
  const auto function = shapeton::ShapeTransferFunction::Parse("0.05-0.15:red:0.3,0.15-0.25:lime:0.5,0.35-0.45:blue:1");
  basetest::ExpectSameWithAnyThreads([&] { return basetest::BytesOf(shapeton::RenderVolume(heat, function, options)); },
                                     { 2, 3, 8 });
}

TEST(VolumeRendering, RefusesWhatCannotBeShown)
{
  const auto heat = MakePhantom();
  EXPECT_THROW(shapeton::RenderVolume(nullptr, {}, {}), std::invalid_argument);
  shapeton::VolumeRenderingOptions options;
  options.elevation = 91.0;
  EXPECT_THROW(shapeton::RenderVolume(heat, {}, options), std::invalid_argument);
  options = {};
  options.zoom = 0.0;
  EXPECT_THROW(shapeton::RenderVolume(heat, {}, options), std::invalid_argument);
  options = {};
  options.width = 0;
  EXPECT_THROW(shapeton::RenderVolume(heat, {}, options), std::invalid_argument);
}

TEST(VolumeRendering, AVolumeOfOneSliceIsShown)
{
  auto image = basetest::NewImage<ImageType>({ { 20, 20, 1 } });
  image->FillBuffer(redHeat);
  shapeton::VolumeRenderingOptions options;
  options.elevation = 90.0;
  EXPECT_GT(
    MeanPlaceOf(shapeton::RenderVolume(image, shapeton::ShapeTransferFunction::Parse(threeLines), options), 0)[2],
    1000.0);
}

TEST(VolumeRendering, Baseline)
{
  shapeton::VolumeRenderingOptions options;
  options.azimuth = 30.0;
  options.elevation = 20.0;
  options.width = 320;
  options.height = 240;
  options.zoom = 2.0;
  const auto function =
    shapeton::ShapeTransferFunction::Parse("0.05-0.15:tomato:1,0.15-0.25:gold:0.4,0.35-0.45:skyblue:1");
  shapeton::ExpectBaseline(shapeton::RenderVolume(MakePhantom(), function, options), "shapetonVolumeRendering.png");
}

TEST(VisibleRegion, HoldsTheVoxelsOfTheLinesAndFillsThePicture)
{
  const auto image = MakeObliqueGrid();
  FillBall(image, redCenter, 7.0, redHeat);
  const auto lines = shapeton::ShapeTransferFunction::Parse(threeLines);
  const auto visible = shapeton::VisibleRegion(image, lines);
  ASSERT_TRUE(visible.has_value());
  EXPECT_NEAR(visible->GetSize(0), 14, 1);
  EXPECT_NEAR(visible->GetSize(1) * 1.5, 14, 2);
  EXPECT_NEAR(visible->GetSize(2) * 2.5, 14, 3);

  shapeton::VolumeRenderingOptions options;
  options.focus = visible;
  const shapeton::PatientView view = shapeton::ViewOfVolume(image, options);
  const auto                  place = view.Project(redCenter);
  EXPECT_NEAR(place[0], 0.5 * (options.width - 1), 1.5 / view.GetMillimetersPerPixel());
  EXPECT_NEAR(place[1], 0.5 * (options.height - 1), 1.5 / view.GetMillimetersPerPixel());
  EXPECT_LT(view.GetMillimetersPerPixel() * options.height, 40.0); // 14 mm, rotated, with a margin
  EXPECT_FALSE(shapeton::VisibleRegion(image, shapeton::ShapeTransferFunction::Parse("0.7-0.8:red:1")).has_value());
}

TEST(PatientView, AxesOfTheFourSides)
{
  const auto image = MakeObliqueGrid();
  const struct
  {
    double       azimuth;
    const char * right;
    const char * forward;
  } sides[] = { { 0, "L", "P" }, { 90, "P", "R" }, { 180, "R", "A" }, { -90, "A", "L" }, { 270, "A", "L" } };
  for (const auto & side : sides)
  {
    shapeton::VolumeRenderingOptions options;
    options.azimuth = side.azimuth;
    const shapeton::PatientView view = shapeton::ViewOfVolume(image, options);
    EXPECT_EQ(shapeton::OrientationLetters(view.GetRight()), side.right) << side.azimuth;
    EXPECT_EQ(shapeton::OrientationLetters(view.GetForward()), side.forward) << side.azimuth;
    EXPECT_EQ(shapeton::OrientationLetters(view.GetUp()), "H");
  }
  shapeton::VolumeRenderingOptions above;
  above.elevation = 90.0;
  EXPECT_EQ(shapeton::OrientationLetters(shapeton::ViewOfVolume(image, above).GetUp()), "P");
  EXPECT_EQ(shapeton::OrientationLetters(shapeton::ViewOfVolume(image, above).GetForward()), "F");
}

TEST(PatientView, ProjectInvertsPointOfPixelAndShowsTheWholeVolume)
{
  const auto                       image = MakeObliqueGrid();
  shapeton::VolumeRenderingOptions options;
  options.azimuth = 33.0;
  options.elevation = -12.0;
  const shapeton::PatientView view = shapeton::ViewOfVolume(image, options);
  const auto                  place = view.Project(view.PointOfPixel(123.5, 77.25));
  EXPECT_NEAR(place[0], 123.5, 1e-9);
  EXPECT_NEAR(place[1], 77.25, 1e-9);
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    PointType point;
    image->TransformIndexToPhysicalPoint({ { corner & 1 ? 99 : 0, corner & 2 ? 65 : 0, corner & 4 ? 39 : 0 } }, point);
    EXPECT_GT(view.Project(point)[0], 0.0);
    EXPECT_LT(view.Project(point)[0], options.width);
    EXPECT_GT(view.Project(point)[1], 0.0);
    EXPECT_LT(view.Project(point)[1], options.height);
  }
}

TEST(PatientOrientation, LettersOfDirections)
{
  const auto letters = [](double x, double y, double z) {
    itk::Vector<double, 3> direction;
    direction[0] = x;
    direction[1] = y;
    direction[2] = z;
    return shapeton::OrientationLetters(direction);
  };
  EXPECT_EQ(letters(1, 0, 0), "L");
  EXPECT_EQ(letters(-2, 0, 0), "R");
  EXPECT_EQ(letters(0, 1, 0), "P");
  EXPECT_EQ(letters(0, -1, 0), "A");
  EXPECT_EQ(letters(0, 0, 3), "H");
  EXPECT_EQ(letters(0, 0, -1), "F");
  EXPECT_EQ(letters(0.6, -0.8, 0.0), "AL");
  EXPECT_EQ(letters(0.99, 0.1, 0.0), "L");
  EXPECT_EQ(letters(0, 0, 0), "");
}
