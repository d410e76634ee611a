#include "shapetonColonPictures.h"
#include "shapetonPictureAnnotation.h"

#include "shapetonPictureTestUtilities.h"
#include "shapetonTestColon.h"
#include "shapetonTestThreads.h"
#include "shapetonTestImages.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace
{
constexpr shapeton::SlicePlane planes[] = { shapeton::SlicePlane::Axial,
                                            shapeton::SlicePlane::Coronal,
                                            shapeton::SlicePlane::Sagittal };

int
PixelsLike(const shapeton::Picture * picture, const shapeton::RGBColor & color, int tolerance = 40)
{
  const shapeton::RGBColor * const begin = picture->GetBufferPointer();
  return static_cast<int>(std::count_if(
    begin, begin + picture->GetBufferedRegion().GetNumberOfPixels(), [&](const shapeton::RGBColor & pixel) {
      return std::abs(pixel[0] - color[0]) + std::abs(pixel[1] - color[1]) + std::abs(pixel[2] - color[2]) <= tolerance;
    }));
}

const shapeton::RGBColor gas = shapeton::MakeColor(64, 224, 255);
const shapeton::RGBColor fluid = shapeton::MakeColor(255, 150, 40);
const shapeton::RGBColor wallLine = shapeton::MakeColor(255, 70, 160);
} // namespace

TEST(ColonPictures, SlicesAreChosenByTheLumen)
{
  auto lumen = basetest::NewImage<itk::Image<unsigned char, 3>>({ { 10, 12, 100 } });
  lumen->FillBuffer(0);
  for (int z = 20; z < 80; ++z)
  {
    lumen->SetPixel({ { 5, 5, z } }, 1);
  }
  lumen->SetPixel({ { 6, 5, 33 } }, 2);
  // At 10/60, 30/60 and 50/60 of the extent; the slice with two voxels replaces the nearest one.
  EXPECT_EQ(shapeton::ChooseSlices(lumen, shapeton::SlicePlane::Axial, 3),
            (std::vector<itk::IndexValueType>{ 33, 50, 70 }));
  EXPECT_EQ(shapeton::ChooseSlices(lumen, shapeton::SlicePlane::Coronal, 3), (std::vector<itk::IndexValueType>{ 5 }));
  EXPECT_EQ(shapeton::ChooseSlices(lumen, shapeton::SlicePlane::Sagittal, 2),
            (std::vector<itk::IndexValueType>{ 5, 6 }));
}

TEST(ColonPictures, TheStorageOfTheVolumeDoesNotMatter)
{
  const shapeton::TestColon reference;
  const shapeton::TestColon other({ { 2, 0, 1 } }, { { true, false, true } });
  for (const auto plane : planes)
  {
    // No centerline, because the labels at its ends may be rounded to the next pixel.
    shapeton::ColonParts parts[] = { reference.Parts(), other.Parts() };
    parts[0].centerline = nullptr;
    parts[1].centerline = nullptr;
    EXPECT_LE(shapeton::GreatestDifference(shapeton::DrawColonProjection(parts[0], plane),
                                           shapeton::DrawColonProjection(parts[1], plane)),
              1);
  }
  // One slice in the middle of the lumen: captions contain slice indices, which differ.
  const auto a = shapeton::DrawColonSlices(reference.Parts(), shapeton::SlicePlane::Coronal, 1);
  const auto b = shapeton::DrawColonSlices(other.Parts(), shapeton::SlicePlane::Coronal, 1);
  ASSERT_EQ(a->GetBufferedRegion(), b->GetBufferedRegion());
  EXPECT_GT(PixelsLike(a, gas), 300);
  EXPECT_NEAR(PixelsLike(a, gas), PixelsLike(b, gas), 3);
}

TEST(ColonPictures, AProjectionMeasuresTheThickness)
{
  // Slabs 40 mm and 10 mm thick from front to back; brightness is proportional to the square root of the thickness.
  auto lumen = basetest::NewImage<itk::Image<unsigned char, 3>>({ { 40, 40, 30 } });
  lumen->FillBuffer(0);
  for (int z = 0; z < 30; ++z)
  {
    for (int x = 0; x < 40; ++x)
    {
      for (int y = 0; y < (x < 20 ? 40 : 10); ++y)
      {
        lumen->SetPixel({ { x, y, z } }, 1 + z % 2);
      }
    }
  }
  shapeton::ColonParts parts;
  parts.lumen = lumen;
  const auto picture = shapeton::DrawColonProjection(parts, shapeton::SlicePlane::Coronal);
  const auto thick = shapeton::At(picture, 200, 300);
  const auto thin = shapeton::At(picture, 700, 300);
  EXPECT_NEAR(thin[0] - 18, 0.5 * (thick[0] - 18), 1.5);
  EXPECT_GT(thick[0], 190);
}

TEST(ColonPictures, SlicesShowLabelsWithAndWithoutACt)
{
  const shapeton::TestColon colon;
  shapeton::ColonParts      parts = colon.Parts();
  for (const auto plane : planes)
  {
    const auto withCt = shapeton::DrawColonSlices(parts, plane);
    EXPECT_GT(PixelsLike(withCt, gas), 200);
    EXPECT_GT(PixelsLike(withCt, fluid), 200);
  }
  parts.ct = nullptr;
  parts.wall = nullptr;
  const auto flat = shapeton::DrawColonSlices(parts, shapeton::SlicePlane::Sagittal);
  EXPECT_GT(PixelsLike(flat, gas), 200);
  EXPECT_EQ(PixelsLike(flat, wallLine), 0);
}

TEST(ColonPictures, TheWallIsSeenWhereItDepartsFromTheLabels)
{
  shapeton::TestColon colon;
  const auto          near = shapeton::DrawColonSlices(colon.Parts(), shapeton::SlicePlane::Coronal);
  for (Eigen::Index i = 0; i < colon.wall.V.rows(); ++i)
  {
    colon.wall.V(i, 2) += 4.0;
  }
  const auto off = shapeton::DrawColonSlices(colon.Parts(), shapeton::SlicePlane::Coronal);
  EXPECT_GT(PixelsLike(off, wallLine), 3 * PixelsLike(near, wallLine));
}

TEST(ColonPictures, BridgesAndEndsAreSeen)
{
  const shapeton::TestColon colon;
  shapeton::ColonParts      parts = colon.Parts();
  const shapeton::RGBColor  bridge = shapeton::MakeColor(250, 214, 60);
  const auto                bridged = shapeton::DrawColonWall(parts, shapeton::PatientSide::Anterior, true);
  shapeton::SurfaceMesh     plain = colon.wall;
  plain.cellArrays.clear();
  parts.wall = &plain;
  const auto unbridged = shapeton::DrawColonWall(parts, shapeton::PatientSide::Anterior, true);
  EXPECT_GT(PixelsLike(bridged, bridge, 90), PixelsLike(unbridged, bridge, 90) + 300);
  // The centerline and the balls at its ends are colored by distance.
  const auto inside = shapeton::DrawColonWall(parts, shapeton::PatientSide::Anterior, false);
  parts.centerline = nullptr;
  EXPECT_THROW(shapeton::DrawColonWall(parts, shapeton::PatientSide::Anterior, false), std::invalid_argument);
  EXPECT_GT(PixelsLike(inside, shapeton::MakeColor(221, 61, 44), 90), 300);
}

TEST(ColonPictures, SameBytesForAnyNumberOfThreads)
{
  const shapeton::TestColon colon;
  basetest::ExpectSameWithAnyThreads(
    [&] { return basetest::BytesOf(shapeton::DrawColonWall(colon.Parts(), shapeton::PatientSide::Left, false)); },
    { 2, 3 });
}

TEST(ColonPictures, RefusesWhatCannotBeDrawn)
{
  const shapeton::TestColon colon;
  shapeton::ColonParts      parts;
  EXPECT_THROW(shapeton::DrawColonSlices(parts, shapeton::SlicePlane::Axial), std::invalid_argument);
  EXPECT_THROW(shapeton::DrawColonProjection(parts, shapeton::SlicePlane::Coronal), std::invalid_argument);
  auto empty = basetest::NewImage<itk::Image<unsigned char, 3>>({ { 5, 5, 5 } });
  empty->FillBuffer(0);
  parts.lumen = empty;
  EXPECT_THROW(shapeton::DrawColonSlices(parts, shapeton::SlicePlane::Axial), std::invalid_argument);
  parts = colon.Parts();
  auto moved = shapeton::NewImageOn<itk::Image<float, 3>>(colon.ct, true);
  moved->FillBuffer(0.0F);
  moved->SetOrigin(colon.ct->GetOrigin() + itk::Vector<double, 3>(1.0));
  parts.ct = moved;
  EXPECT_THROW(shapeton::DrawColonSlices(parts, shapeton::SlicePlane::Axial), std::invalid_argument);
}

TEST(ColonPictures, ColonSlicesBaseline)
{
  shapeton::ExpectBaseline(shapeton::DrawColonSlices(shapeton::TestColon().Parts(), shapeton::SlicePlane::Coronal),
                           "shapetonColonSlices.png");
}

TEST(ColonPictures, ColonProjectionBaseline)
{
  shapeton::ExpectBaseline(shapeton::DrawColonProjection(shapeton::TestColon().Parts(), shapeton::SlicePlane::Coronal),
                           "shapetonColonProjection.png");
}

TEST(ColonPictures, ColonWallBaseline)
{
  shapeton::ExpectBaseline(
    shapeton::DrawColonWall(shapeton::TestColon().Parts(), shapeton::PatientSide::Anterior, false),
    "shapetonColonWall.png");
}

TEST(ColonPictures, NamesOfEndsKeepOffTheOrientationLetters)
{
  shapeton::TestColon colon;
  const auto          without = [&] {
    shapeton::ColonParts parts = colon.Parts();
    parts.centerline = nullptr;
    return shapeton::DrawColonProjection(parts, shapeton::SlicePlane::Coronal);
  }();
  // Left of the middle and 3 mm above the lower border, where a label on the right would cover the letter F.
  colon.centerline.V.row(0) << -8.0, 0.0, -17.0;
  colon.centerline.V.row(1) << -8.0, 0.0, -16.5;
  const auto    with = shapeton::DrawColonProjection(colon.Parts(), shapeton::SlicePlane::Coronal);
  constexpr int left = 12; // of the panel in the page
  constexpr int belowPanel = 46;
  const auto    size = without->GetBufferedRegion().GetSize();
  const int     middle = left + (static_cast<int>(size[0]) - shapeton::colorBarWidth - 10 - 34) / 2;
  const int     bottom = static_cast<int>(size[1]) - belowPanel;
  int           inked = 0;
  for (int y = bottom - 22; y < bottom - 3; ++y)
  {
    for (int x = middle - 8; x <= middle + 8; ++x)
    {
      const shapeton::RGBColor pixel = shapeton::At(without, x, y);
      inked += pixel[0] > 200 && pixel[2] < 180 ? 1 : 0; // letters are yellow
      EXPECT_EQ(shapeton::At(with, x, y), pixel) << x << ", " << y;
    }
  }
  EXPECT_GT(inked, 10) << "the letter is drawn";
}
