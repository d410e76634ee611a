#include "shapetonRegisteredTestPair.h"
#include "shapetonExceptions.h"
#include "shapetonHtmlReport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace
{
using namespace tubecolons;

shapeton::AlignedColonsOptions
Small()
{
  shapeton::AlignedColonsOptions options;
  options.pixelsAround = 100;
  options.greatestColumns = 600;
  return options;
}

int
PixelsLike(const shapeton::Picture * picture, const shapeton::RGBColor & color)
{
  const auto * const pixels = picture->GetBufferPointer();
  return static_cast<int>(std::count(pixels, pixels + picture->GetBufferedRegion().GetNumberOfPixels(), color));
}

int
DifferentPixels(const shapeton::Picture * a, const shapeton::Picture * b)
{
  int number = 0;
  for (itk::SizeValueType i = 0; i < a->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    number += a->GetBufferPointer()[i] != b->GetBufferPointer()[i];
  }
  return number;
}
} // namespace

TEST(RegistrationPictures, FoldsThatTheMapContradictsAreRed)
{
  const shapeton::RGBColor      red = shapeton::MakeColor(230, 20, 20);
  shapeton::RegistrationResults results = TestPair().results;
  shapeton::RegistrationParts   parts = TestPair().Parts();
  parts.results = &results;
  for (shapeton::MatchedFolds & match : results.matches)
  {
    match.weight = 1.0;
    match.verdict = shapeton::FoldVerdict::Unknown;
  }
  const int before = PixelsLike(shapeton::DrawAlignedColons(parts, Small()), red);
  results.matches[3].weight = 0.1;
  const int one = PixelsLike(shapeton::DrawAlignedColons(parts, Small()), red);
  results.matches[9].verdict = shapeton::FoldVerdict::Wrong;
  const int two = PixelsLike(shapeton::DrawAlignedColons(parts, Small()), red);
  EXPECT_EQ(before, 0);
  EXPECT_GT(one, 40); // a crest in both strips
  EXPECT_GT(two, one + 40);
}

TEST(RegistrationPictures, OfOneColonWithItselfBothStripsAreEqual)
{
  const shapeton::ColonPositionFiles & supine = TestPair().supine;
  shapeton::RegistrationResults        same = shapeton::MakeRegistrationResults(
    supine, supine, shapeton::RegisterColonPositions(supine.position, supine.position));
  same.matches.clear(); // with one color for all crests
  const shapeton::RegistrationParts parts{ &supine, &supine, &same };
  const auto                        size = Small();
  const shapeton::Picture::Pointer  page = shapeton::DrawAlignedColons(parts, size);
  // Each row of a strip is repeated below the strip.
  const int gap = 26;
  const int strip = size.pixelsAround + 2 * static_cast<int>(std::lround(0.08 * size.pixelsAround));
  int       equal = 0, all = 0;
  const int top = 12 + 30 + 3 * 20 + 50; // headers of the page and of the row
  for (int y = 0; y < strip; ++y)
  {
    for (int x = 60; x < 500; ++x)
    {
      const auto upper = page->GetPixel({ { x, top + y } });
      const auto lower = page->GetPixel({ { x, top + strip + gap + y } });
      equal += std::abs(upper[0] - lower[0]) + std::abs(upper[1] - lower[1]) + std::abs(upper[2] - lower[2]) < 60;
      ++all;
    }
  }
  EXPECT_GT(equal, 0.95 * all); // borders of segments are only drawn above
}

TEST(RegistrationPictures, ExcludedStretchesAreStriped)
{
  shapeton::RegistrationResults results = TestPair().results;
  shapeton::RegistrationParts   parts = TestPair().Parts();
  parts.results = &results;
  const shapeton::Picture::Pointer before = shapeton::DrawCurvatureCheckerboard(parts, Small());
  for (shapeton::SurfaceArray & array : results.supineToProne.pointArrays)
  {
    for (Eigen::Index i = 0; array.name == "excluded" && i < array.values.rows(); ++i)
    {
      array.values(i, 0) = results.supineToProne.V(i, 2) > 250.0 && results.supineToProne.V(i, 2) < 350.0;
    }
  }
  const double share = 2.0 / 9.0 * 100.0 / length;                     // fraction of the stripes
  const double pixels = 100.0 * 100.0 * length / Form().circumference; // around, and along for 600 mm
  const int    striped = DifferentPixels(before, shapeton::DrawCurvatureCheckerboard(parts, Small()));
  EXPECT_GT(striped, 0.8 * share * pixels);
  EXPECT_LT(striped, 1.5 * share * pixels); // overlap above and below
}

TEST(RegistrationPictures, ChartsNeedPointsOnlyForErrors)
{
  shapeton::RegistrationResults results = TestPair().results;
  shapeton::RegistrationParts   parts = TestPair().Parts();
  parts.results = &results;
  const shapeton::Picture::Pointer sure = shapeton::DrawConfidenceChart(parts);
  EXPECT_NO_THROW(shapeton::DrawErrorChart(parts));
  results.points.clear();
  results.errors.clear();
  EXPECT_THROW(shapeton::DrawErrorChart(parts), std::invalid_argument);
  for (shapeton::SurfaceArray & array : results.supineToProne.pointArrays)
  {
    if (array.name == "confidence")
    {
      array.values.setZero();
    }
  }
  EXPECT_GT(DifferentPixels(sure, shapeton::DrawConfidenceChart(parts)), 500);
}

TEST(RegistrationPictures, ResultsOfOtherExaminationsAreRefused)
{
  const shapeton::ColonPositionFiles other = MakeExamination("supine", 2, {});
  EXPECT_THROW(shapeton::DrawAlignedColons({ &other, &TestPair().prone, &TestPair().results }, Small()),
               shapeton::InputError);
}

TEST(RegistrationReport, ASectionHoldsPicturesAndTheTableOfSegments)
{
  std::vector<std::string> names;
  const auto add = [&](const shapeton::Picture * picture, const std::string & name, const std::string & caption) {
    EXPECT_NE(picture, nullptr);
    EXPECT_FALSE(caption.empty());
    names.push_back(name);
  };
  shapeton::HtmlReport html("two positions");
  shapeton::AddRegistrationSection(html, TestPair().Parts(), add, Small());
  EXPECT_EQ(names, (std::vector<std::string>{ "aligned", "confidence", "checkerboard", "errors" }));
  const auto facts = shapeton::RegistrationFacts(TestPair().Parts());
  EXPECT_EQ(facts.front().first, "Confidence of the registration as a whole");
  EXPECT_EQ(facts.back().first, "Mean error of known points (mm)");
}
