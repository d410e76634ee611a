#include "itkRegistrationReport.h"
#include "itkTestColons.h"
#include "itkExceptions.h"

#include "itkImageRegionConstIterator.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
using namespace tubecolons;

const Movement movement{ 0.37, 8.0 };

/** Two positions, registered once for all tests. */
struct Pair
{
  Pair()
    : supine(MakeExamination("supine", 1, {}))
    , prone(MakeExamination("prone", 1, movement))
    , results(itk::MakeRegistrationResults(supine,
                                           prone,
                                           itk::RegisterColonPositions(supine.position, prone.position),
                                           KnownPoints(movement)))
  {}
  itk::RegistrationParts
  Parts() const
  {
    return { &supine, &prone, &results };
  }

  itk::ColonPositionFiles  supine;
  itk::ColonPositionFiles  prone;
  itk::RegistrationResults results;
};

const Pair &
TestPair()
{
  static const Pair pair;
  return pair;
}

itk::AlignedColonsOptions
Small()
{
  itk::AlignedColonsOptions options;
  options.pixelsAround = 100;
  options.greatestColumns = 600;
  return options;
}

int
PixelsLike(const itk::Picture * picture, const itk::RGBColor & color)
{
  int                                         number = 0;
  itk::ImageRegionConstIterator<itk::Picture> pixel(picture, picture->GetLargestPossibleRegion());
  for (; !pixel.IsAtEnd(); ++pixel)
  {
    number += pixel.Get() == color;
  }
  return number;
}

int
DifferentPixels(const itk::Picture * a, const itk::Picture * b)
{
  int                                         number = 0;
  itk::ImageRegionConstIterator<itk::Picture> first(a, a->GetLargestPossibleRegion());
  itk::ImageRegionConstIterator<itk::Picture> second(b, b->GetLargestPossibleRegion());
  for (; !first.IsAtEnd(); ++first, ++second)
  {
    number += first.Get() != second.Get();
  }
  return number;
}
} // namespace

TEST(RegistrationPictures, FoldsThatTheMapContradictsAreRed)
{
  const itk::RGBColor      red = itk::MakeColor(230, 20, 20);
  itk::RegistrationResults results = TestPair().results;
  itk::RegistrationParts   parts = TestPair().Parts();
  parts.results = &results;
  for (itk::MatchedFolds & match : results.matches)
  {
    match.weight = 1.0;
    match.verdict = itk::FoldVerdict::Unknown;
  }
  const int before = PixelsLike(itk::DrawAlignedColons(parts, Small()), red);
  results.matches[3].weight = 0.1;
  const int one = PixelsLike(itk::DrawAlignedColons(parts, Small()), red);
  results.matches[9].verdict = itk::FoldVerdict::Wrong;
  const int two = PixelsLike(itk::DrawAlignedColons(parts, Small()), red);
  EXPECT_EQ(before, 0);
  EXPECT_GT(one, 40); // a crest in both strips
  EXPECT_GT(two, one + 40);
}

TEST(RegistrationPictures, OfOneColonWithItselfBothStripsAreEqual)
{
  const itk::ColonPositionFiles & supine = TestPair().supine;
  itk::RegistrationResults        same =
    itk::MakeRegistrationResults(supine, supine, itk::RegisterColonPositions(supine.position, supine.position));
  same.matches.clear(); // with one colour for all crests
  const itk::RegistrationParts parts{ &supine, &supine, &same };
  const auto                   size = Small();
  const itk::Picture::Pointer  page = itk::DrawAlignedColons(parts, size);
  // Row by row of the page: each strip is found again below itself.
  const int gap = 26;
  const int strip = size.pixelsAround + 2 * static_cast<int>(std::lround(0.08 * size.pixelsAround));
  int       equal = 0, all = 0;
  const int top = 12 + 30 + 3 * 20 + 50; // head of the page and of the row
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
  EXPECT_GT(equal, 0.95 * all); // borders of segments are drawn above alone
}

TEST(RegistrationPictures, ExcludedStretchesAreStriped)
{
  itk::RegistrationResults results = TestPair().results;
  itk::RegistrationParts   parts = TestPair().Parts();
  parts.results = &results;
  const itk::Picture::Pointer before = itk::DrawCurvatureCheckerboard(parts, Small());
  for (itk::SurfaceArray & array : results.supineToProne.pointArrays)
  {
    for (Eigen::Index i = 0; array.name == "excluded" && i < array.values.rows(); ++i)
    {
      array.values(i, 0) = results.supineToProne.V(i, 2) > 250.0 && results.supineToProne.V(i, 2) < 350.0;
    }
  }
  const double share = 2.0 / 9.0 * 100.0 / length;                     // of the stripes
  const double pixels = 100.0 * 100.0 * length / Form().circumference; // around, and along for 600 mm
  const int    striped = DifferentPixels(before, itk::DrawCurvatureCheckerboard(parts, Small()));
  EXPECT_GT(striped, 0.8 * share * pixels);
  EXPECT_LT(striped, 1.5 * share * pixels); // the strip goes on above and below
}

TEST(RegistrationPictures, ChartsNeedPointsOnlyForErrors)
{
  itk::RegistrationResults results = TestPair().results;
  itk::RegistrationParts   parts = TestPair().Parts();
  parts.results = &results;
  const itk::Picture::Pointer sure = itk::DrawConfidenceChart(parts);
  EXPECT_NO_THROW(itk::DrawErrorChart(parts));
  results.points.clear();
  results.errors.clear();
  EXPECT_THROW(itk::DrawErrorChart(parts), std::invalid_argument);
  for (itk::SurfaceArray & array : results.supineToProne.pointArrays)
  {
    if (array.name == "confidence")
    {
      array.values.setZero();
    }
  }
  EXPECT_GT(DifferentPixels(sure, itk::DrawConfidenceChart(parts)), 500);
}

TEST(RegistrationPictures, ResultsOfOtherExaminationsAreRefused)
{
  const itk::ColonPositionFiles other = MakeExamination("supine", 2, {});
  EXPECT_THROW(itk::DrawAlignedColons({ &other, &TestPair().prone, &TestPair().results }, Small()), itk::InputError);
}

TEST(RegistrationReport, ASectionHoldsPicturesAndTheTableOfSegments)
{
  std::vector<std::string> names;
  const auto add = [&](const itk::Picture * picture, const std::string & name, const std::string & caption) {
    EXPECT_NE(picture, nullptr);
    EXPECT_FALSE(caption.empty());
    names.push_back(name);
  };
  itk::HtmlReport html("two positions");
  itk::AddRegistrationSection(html, TestPair().Parts(), add, Small());
  EXPECT_EQ(names, (std::vector<std::string>{ "aligned", "confidence", "checkerboard", "errors" }));
  const auto facts = itk::RegistrationFacts(TestPair().Parts());
  EXPECT_EQ(facts.front().first, "Confidence");
  EXPECT_EQ(facts.back().first, "Mean error of known points (mm)");
}
