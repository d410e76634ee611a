#include "shapetonOpenEndedProgress.h"
#include "shapetonProgress.h"
#include "shapetonProvenance.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace
{
using Report = std::pair<std::string, double>;

TEST(Progress, OfNothingReportsNothing)
{
  const shapeton::Progress progress;
  EXPECT_NO_THROW(progress("a", 0.5));
  EXPECT_NO_THROW(progress.Part("b", 0.0, 1.0)(0.5));
}

TEST(Progress, OfAPartFillsItsPlaceInTheWhole)
{
  std::vector<Report>      reports;
  const shapeton::Progress whole = [&](const std::string & stage, double share) { reports.emplace_back(stage, share); };
  whole("first", 0.25);
  const shapeton::Progress part = whole.Part("second", 0.5, 1.0);
  part(0.0);
  part.Part("not shown", 0.5, 1.0)("nor this", 0.5);
  part(1.0);
  EXPECT_EQ(reports,
            (std::vector<Report>{ { "first", 0.25 }, { "second", 0.5 }, { "second", 0.875 }, { "second", 1.0 } }));
}

TEST(Progress, OfTheShareAlone)
{
  double                   last = 0.0;
  const shapeton::Progress progress = [&last](double share) { last = share; };
  progress("any stage", 0.75);
  EXPECT_EQ(last, 0.75);
}

TEST(Progress, OfStepsWithoutAnEndStaysBelowOne)
{
  double                      last = 0.0;
  shapeton::OpenEndedProgress steps([&last](double share) { last = share; }, 10.0);
  for (int i = 0; i < 10; ++i)
  {
    const double before = last;
    steps.Step();
    EXPECT_GT(last, before);
  }
  EXPECT_EQ(last, 0.5);
  const shapeton::Progress step = steps.NextStep();
  step(0.0);
  EXPECT_EQ(last, 0.5);
  step(1.0);
  EXPECT_EQ(last, 11.0 / 21.0);
  for (int i = 0; i < 100000; ++i)
  {
    steps.Step();
  }
  EXPECT_LT(last, 1.0);
}

TEST(Progress, AbortsByAnException)
{
  const shapeton::Progress progress = [](double) { throw std::runtime_error("stop"); };
  EXPECT_THROW(progress(0.5), std::runtime_error);
}

TEST(Provenance, StandsAmongOtherFactsAndInOneText)
{
  const shapeton::Provenance provenance = { { "tool", "T" }, { "option.p", "2" } };
  EXPECT_EQ(shapeton::ProvenanceMetadata(provenance),
            (shapeton::Provenance{ { "Shapeton.tool", "T" }, { "Shapeton.option.p", "2" } }));
  EXPECT_EQ(shapeton::ProvenanceComment(provenance), "tool=T; option.p=2");
  EXPECT_EQ(shapeton::ProvenanceComment({}), "");
}
} // namespace
