#include "shapetonFlatColonPage.h"

#include "shapetonFlatColonStrip.h"
#include "shapetonFlatTestColon.h"
#include "shapetonPictureTestUtilities.h"

#include <stdexcept>

namespace
{
using namespace flatcolon;
using shapeton::At;
using shapeton::FlatAnnotation;
using shapeton::FlatColonGrid;

const shapeton::RGBColor plain = shapeton::MakeColor(10, 130, 40);

FlatAnnotation
SegmentAt(const std::string & name, double distance)
{
  FlatAnnotation annotation;
  annotation.kind = FlatAnnotation::Kind::Segment;
  annotation.text = name;
  annotation.distance = distance;
  return annotation;
}

FlatAnnotation
Polyp()
{
  FlatAnnotation annotation;
  annotation.kind = FlatAnnotation::Kind::Polyp;
  annotation.text = "8 mm";
  annotation.point = PointAt(polypU, polypAngle, radius - polypRadius);
  annotation.diameter = 2.0 * polypRadius;
  return annotation;
}

int
CountOf(const shapeton::Picture * picture, const shapeton::RGBColor & color)
{
  const auto * const pixels = picture->GetBufferPointer();
  return static_cast<int>(std::count(pixels, pixels + picture->GetBufferedRegion().GetNumberOfPixels(), color));
}

/** Rows of the picture with a pixel of this color. */
std::vector<int>
RowsWith(const shapeton::Picture * picture, const shapeton::RGBColor & color)
{
  const auto       size = picture->GetBufferedRegion().GetSize();
  std::vector<int> rows;
  for (int y = 0; y < static_cast<int>(size[1]); ++y)
  {
    const auto * const first = picture->GetBufferPointer() + y * size[0];
    if (std::find(first, first + size[0], color) != first + size[0])
    {
      rows.push_back(y);
    }
  }
  return rows;
}

struct Page
{
  explicit Page(double pixelSize = 1.0)
    : mesh(Wall())
    , grid(mesh, { pixelSize, 0.0, 0.0 })
    , strip(shapeton::NewPicture(grid.Columns(), grid.Rows(), plain))
    , distances(DistanceOfColumns(grid))
  {}
  shapeton::SurfaceMesh      mesh;
  FlatColonGrid              grid;
  shapeton::Picture::Pointer strip;
  std::vector<double>        distances;
};
} // namespace

TEST(FlatColonPage, EveryPixelIsThereOnceAndBridgesAreHatched)
{
  const Page                     page;
  shapeton::FlatColonPageOptions options;
  options.overlap = 0.0;
  for (const int columns : { 60, 100, 1000 })
  {
    options.greatestColumns = columns;
    const auto picture = DrawFlatColonPage(page.strip, page.grid, page.distances, {}, options);
    int        covered = 0;
    for (int column = 0; column < page.grid.Columns(); ++column)
    {
      for (int row = 0; row < page.grid.Rows(); ++row)
      {
        covered += !page.grid.IsBridged(column, row);
      }
    }
    EXPECT_EQ(CountOf(picture, plain), covered) << columns;
    EXPECT_GT(CountOf(picture, shapeton::MakeColor(130, 134, 146)), 25 * page.grid.Rows() / 9) << "hatches";
  }
}

TEST(FlatColonPage, LongBridgesAreCutShort)
{
  const Page                     page;
  shapeton::FlatColonPageOptions options;
  options.overlap = 0.0;
  options.longestBridge = 18; // of 25
  const auto cut = DrawFlatColonPage(page.strip, page.grid, page.distances, {}, options);
  options.longestBridge = 0;
  const auto whole = DrawFlatColonPage(page.strip, page.grid, page.distances, {}, options);
  EXPECT_EQ(CountOf(cut, plain), CountOf(whole, plain)) << "no wall is lost";
  const shapeton::RGBColor hatch = shapeton::MakeColor(130, 134, 146);
  EXPECT_LT(CountOf(cut, hatch), 0.75 * CountOf(whole, hatch));
}

TEST(FlatColonPage, TheOverlapGoesOnAroundTheTube)
{
  Page                     page;
  const shapeton::RGBColor line = shapeton::MakeColor(250, 10, 250);
  for (int column = 0; column < page.grid.Columns(); ++column)
  {
    page.strip->SetPixel({ { column, 3 } }, line);
  }
  const auto               picture = DrawFlatColonPage(page.strip, page.grid, page.distances);
  const auto               own = RowsWith(picture, line);
  const shapeton::RGBColor paler = shapeton::MixColors(line, shapeton::MakeColor(255, 255, 255), 0.5);
  const auto               again = RowsWith(picture, paler);
  ASSERT_EQ(own.size(), 1U);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0] - own[0], page.grid.Rows());
}

TEST(FlatColonPage, APolypHasItsRingWhereItLies)
{
  const Page                     page(0.5);
  const shapeton::RGBColor       ring = shapeton::MakeColor(255, 222, 40);
  shapeton::FlatColonPageOptions options;
  options.overlap = 0.0;
  const auto with = DrawFlatColonPage(page.strip, page.grid, page.distances, { Polyp() }, options);
  ASSERT_GT(CountOf(with, ring), 40);
  // Its position follows from the ring's middle row and the strip's first pixel.
  const std::vector<int> stripRows = RowsWith(with, plain);
  int                    left = 0;
  while (At(with, left, stripRows.front()) != plain)
  {
    ++left;
  }
  const int x = left + static_cast<int>(polypU / page.grid.PixelSize());
  const int row =
    stripRows.front() + page.grid.PixelOfUv({ polypU, 2.0 * flattubes::pi * radius - polypAngle * radius }).row;
  const int reach = static_cast<int>(std::lround(polypRadius / 0.5)) + 4; // around the ring the map is not conformal
  int       nearest = 1000;
  for (int away = 1; away < 3 * reach; ++away)
  {
    const auto isRing = [&](const shapeton::RGBColor & color) { return color[0] > 240 && color[2] < 60; };
    nearest = isRing(At(with, x - away, row)) ? std::min(nearest, away) : nearest;
  }
  EXPECT_GE(nearest, reach - 8);
  EXPECT_LE(nearest, reach + 2);
}

TEST(FlatColonPage, RulerTicksLieAtWholeCentimeters)
{
  const Page                     page; // distances are 10 + u: 2 cm at u = 10
  shapeton::FlatColonPageOptions options;
  options.overlap = 0.0;
  const auto               picture = DrawFlatColonPage(page.strip, page.grid, page.distances, {}, options);
  const std::vector<int>   stripRows = RowsWith(picture, plain);
  const shapeton::RGBColor ink = shapeton::MakeColor(30, 32, 38);
  const int                y = stripRows.back() + 3 + 5;
  int                      left = 0;
  while (At(picture, left, stripRows.front()) != plain)
  {
    ++left;
  }
  for (int cm = 2; cm <= 24; ++cm)
  {
    const int x = left + cm * 10 - 10;
    EXPECT_TRUE(At(picture, x, y) == ink || At(picture, x - 1, y) == ink || At(picture, x + 1, y) == ink) << cm;
    EXPECT_NE(At(picture, x + 4, y), ink);
  }
}

TEST(FlatColonPage, APairHasBothStripsBelowEachOtherAndLinksBetween)
{
  const Page                     page;
  const shapeton::RGBColor       other = shapeton::MakeColor(20, 30, 200);
  const shapeton::RGBColor       link = shapeton::MakeColor(250, 0, 250);
  const auto                     lower = shapeton::NewPicture(page.grid.Columns(), page.grid.Rows(), other);
  shapeton::FlatColonPageOptions options;
  options.overlap = 0.0;
  const double                  u = 0.25 * page.grid.Length();
  const shapeton::FlatColonPair pair{ page.strip, lower, "supine", "prone", { { { u, 1.0 }, { u, 9.0 }, link } } };
  const auto                    picture = shapeton::DrawFlatColonPairPage(pair, page.grid, page.distances, {}, options);
  const auto single = shapeton::DrawFlatColonPage(page.strip, page.grid, page.distances, {}, options);
  EXPECT_EQ(CountOf(picture, plain), CountOf(single, plain)); // hatched at the same columns
  EXPECT_EQ(CountOf(picture, other), CountOf(picture, plain));
  const std::vector<int> above = RowsWith(picture, plain), below = RowsWith(picture, other);
  const std::vector<int> between = RowsWith(picture, link);
  ASSERT_FALSE(between.empty());
  EXPECT_GT(between.front(), above.front());
  EXPECT_LT(between.back(), below.back());
  EXPECT_LT(above.front(), below.front());
  EXPECT_THROW(shapeton::DrawFlatColonPairPage(
                 { page.strip, shapeton::NewPicture(3, 3, other), "", "", {} }, page.grid, page.distances),
               std::invalid_argument);
}

TEST(FlatColonPage, RefusesWhatDoesNotFit)
{
  const Page page;
  const auto draw = [&](const shapeton::Picture *   strip,
                        const std::vector<double> & distances,
                        const FlatAnnotation &      note) { DrawFlatColonPage(strip, page.grid, distances, { note }); };
  const auto other = shapeton::NewPicture(10, 10, plain);
  EXPECT_THROW(draw(other, page.distances, Polyp()), std::invalid_argument);
  EXPECT_THROW(draw(page.strip, { 1.0, 2.0 }, Polyp()), std::invalid_argument);
  EXPECT_THROW(draw(page.strip, page.distances, FlatAnnotation()), std::invalid_argument);
  EXPECT_NO_THROW(draw(page.strip, page.distances, Polyp()));
  EXPECT_NO_THROW(draw(page.strip, {}, Polyp()));
  EXPECT_THROW(draw(page.strip, {}, SegmentAt("rectum", 20.0)), std::invalid_argument);
  shapeton::FlatColonPageOptions options;
  options.overlap = 0.7;
  EXPECT_THROW(DrawFlatColonPage(page.strip, page.grid, {}, {}, options), std::invalid_argument);
}

class FlatColonPageOf : public testing::Test
{
public:
  shapeton::FlatColonPageOptions
  Options(const std::string & title) const
  {
    shapeton::FlatColonPageOptions options;
    options.title = title;
    options.note =
      "A made-up piece of colon with folds, taeniae and a polyp; seen from the lumen, light from the left.";
    options.greatestColumns = 480;
    return options;
  }
  Page                        page{ 0.5 };
  shapeton::FlatColonAxis     axis{ MakeFlatColonAxis(page.grid) };
  std::vector<FlatAnnotation> annotations{ SegmentAt("rectum", 10.0), SegmentAt("sigmoid", 80.0), Polyp() };
};

TEST_F(FlatColonPageOf, FlatReliefBaseline)
{
  const auto strip = PaintFlatRelief(page.grid, axis);
  shapeton::ExpectBaseline(DrawFlatColonPage(strip, page.grid, page.distances, annotations, Options("Shaded relief")),
                           "shapetonFlatRelief.png");
}

TEST_F(FlatColonPageOf, FlatCurvatureBaseline)
{
  const auto                     strip = PaintFlatCurvature(page.grid, axis);
  shapeton::FlatColonPageOptions options = Options("Curvature");
  options.colorBar = shapeton::CurvatureScale();
  shapeton::ExpectBaseline(DrawFlatColonPage(strip, page.grid, page.distances, annotations, options),
                           "shapetonFlatCurvature.png");
}

TEST(FlatColonPage, ASegmentThatSoonEndsLeavesItsPlaceToTheNext)
{
  const Page                     page;
  shapeton::FlatColonPageOptions options;
  const auto                     draw = [&](const std::vector<FlatAnnotation> & annotations) {
    return DrawFlatColonPage(page.strip, page.grid, page.distances, annotations, options);
  };
  options.greatestColumns = 120; // the second row begins at 130 mm
  const auto with = draw({ SegmentAt("a name with a long text", 20.0), SegmentAt("rectum", 135.0) });
  const auto without = draw({ SegmentAt("rectum", 135.0) });
  const auto size = with->GetBufferedRegion().GetSize();
  ASSERT_EQ(size, without->GetBufferedRegion().GetSize());
  for (int y = static_cast<int>(size[1]) / 2; y < static_cast<int>(size[1]); ++y)
  {
    for (int x = 0; x < static_cast<int>(size[0]); ++x)
    {
      ASSERT_EQ(shapeton::At(with, x, y), shapeton::At(without, x, y)) << x << ", " << y;
    }
  }
}
