#include "shapetonRegistrationErrors.h"
#include "shapetonRegistrationSchemes.h"
#include "shapetonProgressTests.h"
#include "shapetonTestColons.h"
#include "shapetonTestErrors.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace
{
using namespace tubecolons;
using flattubes::pi;

constexpr double halfCollapse = 20.0; // mm

Movement
SomeMovement()
{
  return { 0.37, 8.0 };
}

/** The position with a collapsed stretch where the wall is not visible, by default in the middle of the tube. */
shapeton::ColonPosition
WithCollapse(shapeton::ColonPosition position, double middle = 0.5 * length)
{
  const auto isInside = [middle](double u) { return std::abs(u - middle) < halfCollapse; };
  position.isExcluded.assign(position.flat->Grid().Columns(), 0);
  for (int column = 0; column < position.flat->Grid().Columns(); ++column)
  {
    position.isExcluded[column] = isInside(position.flat->Grid().UvOfPixel(column, 0).x());
  }
  const auto seen = std::remove_if(position.folds.begin(),
                                   position.folds.end(),
                                   [&](const shapeton::HaustralFold & fold) { return isInside(fold.centerUv.x()); });
  position.folds.erase(seen, position.folds.end());
  return position;
}

/** Largest error of a map (mm of the flat map) over the tube, except within the given distance from its middle. */
double
GreatestError(const shapeton::SupineProneRegistration & registration,
              const shapeton::CylinderMap &             map,
              const Movement &                          movement,
              double                                    withoutMiddle = 0.0)
{
  const double circumference = 2.0 * pi * radius;
  double       greatest = 0.0;
  for (double s = 40.0; s < length - 40.0; s += 13.0)
  {
    for (double turn = 0.03; turn < 1.0; turn += 0.11)
    {
      if (std::abs(s - 0.5 * length) < withoutMiddle)
      {
        continue;
      }
      const shapeton::CylinderPlace goal = movement({ s, turn });
      const Eigen::Vector2d         from(s, turn * circumference);
      const Eigen::Vector2d uv = registration.target->UvOfPlace(map.Forward(registration.source->PlaceOfUv(from)));
      greatest = std::max(
        greatest,
        std::hypot(uv.x() - goal.s, shapeton::TurnDifference(uv.y() / circumference, goal.turn) * circumference));
    }
  }
  return greatest;
}

double
GreatestError(const shapeton::SupineProneRegistration & registration, const Movement & movement)
{
  return GreatestError(registration, registration.map, movement);
}

constexpr double period = 24.0; // mm

constexpr double periodicBegin = 0.25 * length - halfCollapse;
constexpr double periodicEnd = 0.75 * length + halfCollapse;

/** A colon whose folds are evenly spaced rings in its middle part, the first of them `phase` mm after the beginning of
 * that part, and unevenly spaced elsewhere. */
shapeton::ColonPosition
MakePeriodicPosition(const std::string & name, double phase)
{
  std::vector<Fold> folds;
  for (const Fold & fold : FoldsOfPatient(1))
  {
    if (fold.s < periodicBegin || fold.s > periodicEnd)
    {
      folds.push_back(fold);
    }
  }
  for (double s = periodicBegin + phase; s < periodicEnd; s += period)
  {
    for (const double turn : { 1.0 / 6.0, 0.5, 5.0 / 6.0 })
    {
      folds.push_back({ s, turn });
    }
  }
  return MakeExamination(name, folds, {}).position;
}

/** Local confidences from `begin` to `end` (mm). */
std::vector<double>
ConfidencesBetween(const shapeton::SupineProneRegistration & registration, double begin, double end)
{
  std::vector<double> confidences;
  for (double s = begin; s < end; s += 5.0)
  {
    for (double turn = 0.0; turn < 1.0; turn += 0.1)
    {
      confidences.push_back(ConfidenceAt(registration, { firstArc + s, turn }));
    }
  }
  return confidences;
}

double
Mean(const std::vector<double> & values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
} // namespace

TEST(SupineProneRegistration, FindsAKnownMovementWithConfidence)
{
  const auto registration =
    shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, SomeMovement()));
  EXPECT_LT(GreatestError(registration, SomeMovement()), 3.0);
  EXPECT_EQ(registration.figures.flips, 0);
  EXPECT_FALSE(registration.confidence.isFlagged);
  for (const shapeton::FoldMatch & match : registration.matches)
  {
    EXPECT_EQ(match.source.fold, match.target.fold);
  }
  EXPECT_GT(registration.matches.size(), 0.9 * FoldsOfPatient(1).size());
  // The margin tells the right third, and the local confidence of uneven folds is high.
  const std::vector<double> & energies = registration.confidence.energies;
  ASSERT_EQ(energies.size(), 3U);
  EXPECT_LT(energies[0], std::min(energies[1], energies[2]));
  EXPECT_DOUBLE_EQ(registration.confidence.margin, std::min(energies[1], energies[2]) - energies[0]);
  const std::vector<double> confidences = ConfidencesBetween(registration, 50.0, length - 50.0);
  EXPECT_GT(*std::min_element(confidences.begin(), confidences.end()), 0.8);
  const Eigen::Vector2d uv(200.0, 33.0);
  EXPECT_LT((shapeton::InverseMapUv(registration, shapeton::MapUv(registration, uv)) - uv).norm(), 1e-6);
}

/** Taeniae alone cannot reveal a rotation by a third of a turn where the wall is not visible, since their angles at
 * both ends are the same. */
TEST(SupineProneRegistration, TheRotationMayChangeInACollapse)
{
  Movement movement = SomeMovement();
  movement.turnBehind = 1.0 / 3.0;
  const auto registration = shapeton::RegisterColonPositions(WithCollapse(MakePosition("supine", 1, {})),
                                                             WithCollapse(MakePosition("prone", 1, movement)));
  EXPECT_LT(GreatestError(registration, registration.map, movement, 2.5 * halfCollapse), 4.0);
  EXPECT_EQ(registration.figures.flips, 0);
  EXPECT_FALSE(registration.confidence.isFlagged);
}

/** Periodic folds between two collapsed stretches of the source fit equally well if they moved by half a period to
 * either side, so the map is right for one of two movements. */
TEST(SupineProneRegistration, TheLocalConfidenceOfPeriodicFoldsIsAboutTheShareOfRightChoices)
{
  const shapeton::ColonPosition supine =
    WithCollapse(WithCollapse(MakePeriodicPosition("supine", 0.0), 0.25 * length), 0.75 * length);
  const auto registration = shapeton::RegisterColonPositions(supine, MakePeriodicPosition("prone", 0.5 * period));
  int        right = 0;
  int        choices = 0;
  for (const double moved : { -0.5 * period, 0.5 * period })
  {
    for (double s = 0.4 * length; s < 0.6 * length; s += 5.0)
    {
      right += std::abs(registration.map.Forward({ firstArc + s, 0.5 }).s - firstArc - s - moved) <=
               shapeton::ConfidentDistance;
      ++choices;
    }
  }
  const double share = static_cast<double>(right) / choices;
  EXPECT_EQ(share, 0.5);
  // According to the model, the movement in the map is slightly more likely than the other one.
  constexpr double tolerance = 0.1;
  EXPECT_LE(Mean(ConfidencesBetween(registration, 0.4 * length, 0.6 * length)), share + tolerance);
  EXPECT_GT(Mean(ConfidencesBetween(registration, 40.0, periodicBegin - 20.0)), 0.7);
  EXPECT_GT(Mean(ConfidencesBetween(registration, periodicEnd + 20.0, length - 40.0)), 0.7);
}

TEST(SupineProneRegistration, TheLocalConfidenceDoesNotDependOnThreads)
{
  basetest::ExpectSameWithAnyThreads(
    [] {
      return shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, SomeMovement()))
        .confidence.ofNodes;
    },
    { 3 });
}

TEST(SupineProneRegistration, TwoPatientsAreFlagged)
{
  const auto registration =
    shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 2, SomeMovement()));
  EXPECT_TRUE(registration.confidence.isFlagged);
  EXPECT_FALSE(registration.confidence.reasons.empty());
}

TEST(SupineProneRegistration, EvidenceOfOnePatientAddsUp)
{
  const auto probability = [](double matchedShare, double energy, double margin, double senseMargin) {
    shapeton::RegistrationConfidence confidence;
    confidence.matchedShare = matchedShare;
    confidence.energy = energy;
    confidence.margin = margin;
    confidence.senseMargin = senseMargin;
    return confidence.ProbabilityOfOnePatient();
  };
  // Best values in 14 pairs of two patients, and worst values in 20 pairs of one patient.
  EXPECT_LT(probability(0.75, 0.13, 0.15, 0.042), 0.5);
  EXPECT_GT(probability(0.80, 0.13, 0.14, 0.052), 0.5);
  // Many folds are visible in only one position, but the picture fits in only one orientation.
  EXPECT_GT(probability(0.61, 0.14, 0.23, 0.096), 0.9);
  // A few folds of two patients are similar, but they fit equally well in another orientation.
  EXPECT_LT(probability(0.94, 0.106, 0.33, 0.037), 0.5);
  EXPECT_LT(probability(1.0, 0.2, 0.05, 0.0), 0.5);
  EXPECT_LT(probability(0.6, 0.2, 0.05, 0.2), 0.5);
}

/** As in the dissertation: the constraints hold, and the figures report flips and dilatation. */
TEST(SupineProneRegistration, ThePublishedMapGoesThroughTheEndsNearTheMainTaenia)
{
  const shapeton::ColonPosition supine = MakePosition("supine", 1, {});
  const shapeton::ColonPosition prone = MakePosition("prone", 1, SomeMovement());
  shapeton::SupineProneSettings options;
  options.map = shapeton::SupineProneMap::Published;
  const auto registration = shapeton::RegisterColonPositions(supine, prone, options);
  EXPECT_LT(GreatestError(registration, SomeMovement()), 5.0);
  EXPECT_LT(registration.figures.greatestMiss, 1e-3);
  EXPECT_EQ(registration.figures.flips, registration.map.Flips());
  // One of three taeniae, each with as many ends, is the main one.
  EXPECT_NEAR(registration.sourceLandmarks.size(), 2.0 / 3.0 * FoldsOfPatient(1).size(), 4.0);
  EXPECT_GT(registration.matches.size(), 0.9 * registration.sourceLandmarks.size());
  for (const shapeton::FoldMatch & match : registration.matches)
  {
    EXPECT_EQ(match.source.fold, match.target.fold);
    EXPECT_EQ(match.source.end, match.target.end);
    const auto from = registration.source->PlaceOfUv(match.source.Uv(supine.folds));
    const auto to = registration.target->PlaceOfUv(match.target.Uv(prone.folds));
    EXPECT_LE(std::abs(shapeton::TurnDifference(from.turn, 0.0)) * 2.0 * pi * radius, options.border);
    const shapeton::CylinderPlace mapped = registration.map.Forward(from);
    EXPECT_NEAR(mapped.s, to.s, 1e-3);
    EXPECT_NEAR(shapeton::TurnDifference(mapped.turn, to.turn) * 2.0 * pi * radius, 0.0, 1e-3);
  }
  for (double s = 40.0; s < length - 40.0; s += 9.0)
  {
    EXPECT_NEAR(
      shapeton::TurnDifference(registration.map.Forward({ s, 0.0 }).turn, SomeMovement().rotation), 0.0, 0.01);
  }
  for (const auto & [source, target] : registration.flexures)
  {
    EXPECT_NEAR(registration.map.Forward({ source, 0.4 }).s, target, 1e-3);
  }
}

/** A border as wide as half the colon leaves nothing in the middle. */
TEST(SupineProneRegistration, AWideBorderConstrainsThePublishedMapByAllEnds)
{
  shapeton::SupineProneSettings options;
  options.map = shapeton::SupineProneMap::Published;
  options.border = pi * radius + 1.0;
  const auto registration =
    shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, SomeMovement()), options);
  EXPECT_EQ(registration.sourceLandmarks.size(), 2 * FoldsOfPatient(1).size());
  EXPECT_LT(GreatestError(registration, SomeMovement()), 4.0);
}

TEST(SupineProneRegistration, TaeniaeGetCommonNumbers)
{
  const shapeton::ColonPosition supine = MakePosition("supine", 1, {});
  shapeton::ColonPosition       prone = MakePosition("prone", 1, SomeMovement());
  const auto                    same = shapeton::RegisterColonPositions(supine, prone).taeniae;
  EXPECT_EQ(same.target, (std::array<int, 3>{ { 0, 1, 2 } }));
  EXPECT_GT(same.probability, 0.8);
  std::rotate(prone.taeniae.curves.begin(), prone.taeniae.curves.begin() + 1, prone.taeniae.curves.end());
  EXPECT_EQ(shapeton::RegisterColonPositions(supine, prone).taeniae.target, (std::array<int, 3>{ { 2, 0, 1 } }));
  std::swap(prone.taeniae.curves[0], prone.taeniae.curves[1]);
  EXPECT_EQ(shapeton::RegisterColonPositions(supine, prone).taeniae.target, (std::array<int, 3>{ { 2, 1, 0 } }));
  prone.taeniae = {};
  const auto unknown = shapeton::RegisterColonPositions(supine, prone).taeniae;
  EXPECT_FALSE(unknown.AreKnown());
  EXPECT_EQ(unknown.probability, 0.0);
}

TEST(SupineProneRegistration, OptionsOfTheOtherMapAreRefused)
{
  using Settings = shapeton::SupineProneSettings;
  const auto expectRefusal = [](const std::function<void(Settings &)> & change) {
    Settings options;
    change(options);
    EXPECT_THROW(shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, {}), options),
                 shapeton::ParameterError);
  };
  constexpr auto published = shapeton::SupineProneMap::Published;
  expectRefusal([](Settings & options) {
    options.map = published;
    options.refine = true;
  });
  expectRefusal([](Settings & options) {
    options.map = published;
    options.matching = shapeton::FoldMatchingMethod::DualDecomposition;
  });
  expectRefusal([](Settings & options) { options.distanceWeight = 0.5; });
  expectRefusal([](Settings & options) { options.border = 5.0; });
}

TEST(SupineProneRegistration, ThePublishedMapNeedsTaeniae)
{
  shapeton::ColonPosition prone = MakePosition("prone", 1, SomeMovement());
  prone.taeniae = {};
  shapeton::SupineProneSettings options;
  options.map = shapeton::SupineProneMap::Published;
  EXPECT_TRUE(basetest::Refuses(
    [&] { shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), prone, options); }, "needs the taeniae"));
}

TEST(SupineProneRegistration, AColonThatRunsTheOtherWayIsRefused)
{
  const auto reversed = MakePosition("prone", 1, SomeMovement(), true);
  EXPECT_TRUE(basetest::Refuses([&] { shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), reversed); },
                                "runs from the cecum to the rectum"));
}

TEST(SupineProneRegistration, WithoutLandmarksOrFoldsThereIsNoMap)
{
  const shapeton::ColonPosition supine = MakePosition("supine", 1, {});
  shapeton::ColonPosition       prone = MakePosition("prone", 1, SomeMovement());
  prone.taeniae = {};
  prone.flexures.fill(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(shapeton::RegisterColonPositions(supine, prone), shapeton::InputError);
  prone = MakePosition("prone", 1, SomeMovement());
  prone.folds.clear();
  EXPECT_THROW(shapeton::RegisterColonPositions(supine, prone), shapeton::InputError);
}

TEST(SupineProneRegistration, ErrorsAreMeasuredAgainstPointsInSpace)
{
  const auto same = shapeton::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, {}));
  std::vector<shapeton::PointPair> pairs;
  for (double u = 50.0; u < 550.0; u += 10.0)
  {
    const Eigen::Vector3d point = flattubes::OnCylinder(radius, u, 0.0); // on a taenia, without folds
    pairs.push_back({ point, point });
  }
  pairs.push_back({ Eigen::Vector3d(500.0, 0.0, 0.0), Eigen::Vector3d(500.0, 0.0, 0.0) });
  const shapeton::RegistrationErrors errors = shapeton::MeasureRegistrationErrors(same, pairs);
  EXPECT_EQ(errors.offSurface, 1);
  EXPECT_EQ(errors.inSpace.size(), 50U);
  EXPECT_LT(errors.Mean(), 1.0);
  EXPECT_EQ(errors.ShareWithin10(), 1.0);
}

TEST(SupineProneRegistration, SimplerSchemesFindWhatTheyCanExpress)
{
  using Scheme = shapeton::RegistrationScheme;
  const auto errorOf = [](Scheme scheme, const Movement & movement) {
    const shapeton::ColonPosition supine = MakePosition("supine", 1, {});
    const shapeton::ColonPosition prone = MakePosition("prone", 1, movement);
    const auto                    registration = shapeton::RegisterColonPositions(supine, prone);
    return GreatestError(registration, shapeton::MapOfScheme(scheme, supine, prone, registration), movement);
  };
  const Movement turned{ 0.375, 0.0 }; // one of the 48 rotations tested by the schemes
  for (const Scheme scheme : { Scheme::Rectangles, Scheme::Centerline, Scheme::Landmarks })
  {
    EXPECT_LT(errorOf(scheme, turned), 3.0) << static_cast<int>(scheme);
  }
  const Movement both = SomeMovement();
  EXPECT_GT(errorOf(Scheme::Centerline, both), 7.0); // cannot follow 8 mm of stretch
  EXPECT_LT(errorOf(Scheme::Warping, both), 5.0);
  EXPECT_LT(errorOf(Scheme::QuasiConformal, both), 4.0);
}

TEST(SupineProneRegistration, IsAbortedByProgressWhateverTheMap)
{
  const shapeton::ColonPosition supine = MakePosition("supine", 1, {});
  const shapeton::ColonPosition prone = MakePosition("prone", 1, SomeMovement());
  for (const bool isPublished : { false, true })
  {
    const auto work = [&](const shapeton::Progress & progress) {
      shapeton::SupineProneSettings options;
      options.map = isPublished ? shapeton::SupineProneMap::Published : shapeton::SupineProneMap::Default;
      options.refine = !isPublished;
      options.progress = progress;
      RegisterColonPositions(supine, prone, options);
    };
    shapeton::test::ExpectProgress(work, 500); // including one call per row of each warp
  }
}
