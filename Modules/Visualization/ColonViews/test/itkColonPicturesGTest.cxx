#include "itkColonPictures.h"
#include "itkPictureAnnotation.h"

#include "itkPictureTestUtilities.h"
#include "itkTestColon.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace
{
constexpr itk::SlicePlane planes[] = { itk::SlicePlane::Axial, itk::SlicePlane::Coronal, itk::SlicePlane::Sagittal };

int
PixelsLike(const itk::Picture * picture, const itk::RGBColor & color, int tolerance = 40)
{
  const itk::RGBColor * const begin = picture->GetBufferPointer();
  return static_cast<int>(
    std::count_if(begin, begin + picture->GetBufferedRegion().GetNumberOfPixels(), [&](const itk::RGBColor & pixel) {
      return std::abs(pixel[0] - color[0]) + std::abs(pixel[1] - color[1]) + std::abs(pixel[2] - color[2]) <= tolerance;
    }));
}

const itk::RGBColor gas = itk::MakeColor(64, 224, 255);
const itk::RGBColor fluid = itk::MakeColor(255, 150, 40);
const itk::RGBColor wallLine = itk::MakeColor(255, 70, 160);
} // namespace

TEST(ColonPictures, SlicesAreChosenByTheLumen)
{
  auto lumen = itk::Image<unsigned char, 3>::New();
  lumen->SetRegions(itk::Size<3>{ { 10, 12, 100 } });
  lumen->Allocate();
  lumen->FillBuffer(0);
  for (int z = 20; z < 80; ++z)
  {
    lumen->SetPixel({ { 5, 5, z } }, 1);
  }
  lumen->SetPixel({ { 6, 5, 33 } }, 2);
  // Ten, thirty and fifty sixtieths of the way; the slice with two voxels takes the place of the nearest.
  EXPECT_EQ(itk::ChooseSlices(lumen, itk::SlicePlane::Axial, 3), (std::vector<itk::IndexValueType>{ 33, 50, 70 }));
  EXPECT_EQ(itk::ChooseSlices(lumen, itk::SlicePlane::Coronal, 3), (std::vector<itk::IndexValueType>{ 5 }));
  EXPECT_EQ(itk::ChooseSlices(lumen, itk::SlicePlane::Sagittal, 2), (std::vector<itk::IndexValueType>{ 5, 6 }));
}

TEST(ColonPictures, TheStorageOfTheVolumeDoesNotMatter)
{
  const itk::TestColon reference;
  const itk::TestColon other({ { 2, 0, 1 } }, { { true, false, true } });
  for (const auto plane : planes)
  {
    // Names at the ends may be rounded to the next pixel: no centreline.
    itk::ColonParts parts[] = { reference.Parts(), other.Parts() };
    parts[0].centreline = nullptr;
    parts[1].centreline = nullptr;
    EXPECT_LE(
      itk::GreatestDifference(itk::DrawColonProjection(parts[0], plane), itk::DrawColonProjection(parts[1], plane)), 1);
  }
  // Captions name slices by index, which do differ; a single slice in the middle of the lumen is the same.
  const auto a = itk::DrawColonSlices(reference.Parts(), itk::SlicePlane::Coronal, 1);
  const auto b = itk::DrawColonSlices(other.Parts(), itk::SlicePlane::Coronal, 1);
  ASSERT_EQ(a->GetBufferedRegion(), b->GetBufferedRegion());
  EXPECT_GT(PixelsLike(a, gas), 300);
  EXPECT_NEAR(PixelsLike(a, gas), PixelsLike(b, gas), 3);
}

TEST(ColonPictures, AProjectionMeasuresTheThickness)
{
  // A slab 40 mm thick from front to back and one of 10 mm: brightness is the square root of the share.
  auto lumen = itk::Image<unsigned char, 3>::New();
  lumen->SetRegions(itk::Size<3>{ { 40, 40, 30 } });
  lumen->Allocate();
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
  itk::ColonParts parts;
  parts.lumen = lumen;
  const auto picture = itk::DrawColonProjection(parts, itk::SlicePlane::Coronal);
  const auto thick = itk::At(picture, 200, 300);
  const auto thin = itk::At(picture, 700, 300);
  EXPECT_NEAR(thin[0] - 18, 0.5 * (thick[0] - 18), 1.5);
  EXPECT_GT(thick[0], 190);
}

TEST(ColonPictures, SlicesShowLabelsWithAndWithoutACt)
{
  const itk::TestColon colon;
  itk::ColonParts      parts = colon.Parts();
  for (const auto plane : planes)
  {
    const auto withCt = itk::DrawColonSlices(parts, plane);
    EXPECT_GT(PixelsLike(withCt, gas), 200);
    EXPECT_GT(PixelsLike(withCt, fluid), 200);
  }
  parts.ct = nullptr;
  parts.wall = nullptr;
  const auto flat = itk::DrawColonSlices(parts, itk::SlicePlane::Sagittal);
  EXPECT_GT(PixelsLike(flat, gas), 200);
  EXPECT_EQ(PixelsLike(flat, wallLine), 0);
}

TEST(ColonPictures, TheWallIsSeenWhereItDepartsFromTheLabels)
{
  itk::TestColon colon;
  const auto     near = itk::DrawColonSlices(colon.Parts(), itk::SlicePlane::Coronal);
  for (Eigen::Index i = 0; i < colon.wall.V.rows(); ++i)
  {
    colon.wall.V(i, 2) += 4.0;
  }
  const auto off = itk::DrawColonSlices(colon.Parts(), itk::SlicePlane::Coronal);
  EXPECT_GT(PixelsLike(off, wallLine), 3 * PixelsLike(near, wallLine));
}

TEST(ColonPictures, BridgesAndEndsAreSeen)
{
  const itk::TestColon colon;
  itk::ColonParts      parts = colon.Parts();
  const itk::RGBColor  bridge = itk::MakeColor(250, 214, 60);
  const auto           bridged = itk::DrawColonWall(parts, itk::PatientSide::Anterior, true);
  itk::SurfaceMesh     plain = colon.wall;
  plain.cellArrays.clear();
  parts.wall = &plain;
  const auto unbridged = itk::DrawColonWall(parts, itk::PatientSide::Anterior, true);
  EXPECT_GT(PixelsLike(bridged, bridge, 90), PixelsLike(unbridged, bridge, 90) + 300);
  // The tube of the centreline and the balls at its ends have the colours of the distance.
  const auto inside = itk::DrawColonWall(parts, itk::PatientSide::Anterior, false);
  parts.centreline = nullptr;
  EXPECT_THROW(itk::DrawColonWall(parts, itk::PatientSide::Anterior, false), std::invalid_argument);
  EXPECT_GT(PixelsLike(inside, itk::MakeColor(221, 61, 44), 90), 300);
}

TEST(ColonPictures, SameBytesForAnyNumberOfThreads)
{
  const itk::TestColon colon;
  const auto           draw = [&](unsigned int threads) {
    const itk::ThreadNumber number(threads);
    return itk::DrawColonWall(colon.Parts(), itk::PatientSide::Left, false);
  };
  const auto one = draw(1);
  EXPECT_EQ(itk::GreatestDifference(one, draw(2)), 0);
  EXPECT_EQ(itk::GreatestDifference(one, draw(3)), 0);
}

TEST(ColonPictures, RefusesWhatCannotBeDrawn)
{
  const itk::TestColon colon;
  itk::ColonParts      parts;
  EXPECT_THROW(itk::DrawColonSlices(parts, itk::SlicePlane::Axial), std::invalid_argument);
  EXPECT_THROW(itk::DrawColonProjection(parts, itk::SlicePlane::Coronal), std::invalid_argument);
  auto empty = itk::Image<unsigned char, 3>::New();
  empty->SetRegions(itk::Size<3>{ { 5, 5, 5 } });
  empty->Allocate();
  empty->FillBuffer(0);
  parts.lumen = empty;
  EXPECT_THROW(itk::DrawColonSlices(parts, itk::SlicePlane::Axial), std::invalid_argument);
  parts = colon.Parts();
  auto moved = itk::Image<float, 3>::New();
  moved->CopyInformation(colon.ct);
  moved->SetRegions(colon.ct->GetBufferedRegion());
  moved->Allocate();
  moved->FillBuffer(0.0F);
  moved->SetOrigin(colon.ct->GetOrigin() + itk::Vector<double, 3>(1.0));
  parts.ct = moved;
  EXPECT_THROW(itk::DrawColonSlices(parts, itk::SlicePlane::Axial), std::invalid_argument);
}

TEST(ColonPictures, ColonSlicesBaseline)
{
  itk::ExpectBaseline(itk::DrawColonSlices(itk::TestColon().Parts(), itk::SlicePlane::Coronal), "itkColonSlices.png");
}

TEST(ColonPictures, ColonProjectionBaseline)
{
  itk::ExpectBaseline(itk::DrawColonProjection(itk::TestColon().Parts(), itk::SlicePlane::Coronal),
                      "itkColonProjection.png");
}

TEST(ColonPictures, ColonWallBaseline)
{
  itk::ExpectBaseline(itk::DrawColonWall(itk::TestColon().Parts(), itk::PatientSide::Anterior, false),
                      "itkColonWall.png");
}

TEST(ColonPictures, NamesOfEndsKeepOffTheOrientationLetters)
{
  itk::TestColon colon;
  const auto     without = [&] {
    itk::ColonParts parts = colon.Parts();
    parts.centreline = nullptr;
    return itk::DrawColonProjection(parts, itk::SlicePlane::Coronal);
  }();
  // Left of the middle and 3 mm above the lower border: a name to the right of it would cover the letter F.
  colon.centreline.V.row(0) << -8.0, 0.0, -17.0;
  colon.centreline.V.row(1) << -8.0, 0.0, -16.5;
  const auto    with = itk::DrawColonProjection(colon.Parts(), itk::SlicePlane::Coronal);
  constexpr int left = 12; // of the panel in the page
  constexpr int belowPanel = 46;
  const auto    size = without->GetBufferedRegion().GetSize();
  const int     middle = left + (static_cast<int>(size[0]) - itk::colorBarWidth - 10 - 34) / 2;
  const int     bottom = static_cast<int>(size[1]) - belowPanel;
  int           inked = 0;
  for (int y = bottom - 22; y < bottom - 3; ++y)
  {
    for (int x = middle - 8; x <= middle + 8; ++x)
    {
      const itk::RGBColor pixel = itk::At(without, x, y);
      inked += pixel[0] > 200 && pixel[2] < 180 ? 1 : 0; // letters are yellow
      EXPECT_EQ(itk::At(with, x, y), pixel) << x << ", " << y;
    }
  }
  EXPECT_GT(inked, 10) << "the letter is there";
}
