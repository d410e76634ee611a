#include "itkFlatTestTubes.h"
#include "itkRegistrationErrors.h"
#include "itkToolError.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using flattubes::pi;
constexpr double radius = 20.0;
constexpr double length = 600.0;

struct Fold
{
  double s;    ///< mm
  double turn; ///< of its middle
};

double
Uneven(int i)
{
  const double value = std::sin(12.9898 * i + 78.233) * 43758.5453;
  return value - std::floor(value);
}

/** Between three bands at the turns 0, 1/3 and 2/3, with uneven gaps. */
std::vector<Fold>
FoldsOfPatient(int patient)
{
  std::vector<Fold> folds;
  for (int row = 0; row < 3; ++row)
  {
    int k = 1000 * patient + 100 * row;
    for (double s = 12.0 + 20.0 * Uneven(k); s < length - 12.0; s += 14.0 + 26.0 * Uneven(++k))
    {
      folds.push_back({ s, (row + 0.5) / 3.0 });
    }
  }
  return folds;
}

/** Where the second position has a place of the first one. */
struct Movement
{
  double rotation{ 0.0 }; ///< turns
  double stretch{ 0.0 };  ///< mm, at most
  double
  S(double s) const
  {
    return s + stretch * std::sin(2.0 * pi * s / length);
  }
  itk::CylinderPlace
  operator()(const itk::CylinderPlace & place) const
  {
    return { this->S(place.s), place.turn + rotation };
  }
};

/** The colon of a patient as a straight tube with folds that stand 5 mm high; `isReversed` begins at the caecum. */
itk::ColonPosition
MakePosition(const std::string & name, int patient, const Movement & movement, bool isReversed = false)
{
  std::vector<itk::CylinderPlace> places;
  for (const Fold & fold : FoldsOfPatient(patient))
  {
    const itk::CylinderPlace moved = movement({ fold.s, fold.turn });
    places.push_back(isReversed ? itk::CylinderPlace{ length - moved.s, -moved.turn } : moved);
  }
  flattubes::TubeForm form;
  form.around = 60;
  form.along = 300;
  form.circumference = 2.0 * pi * radius;
  form.length = length;
  itk::ColonPosition position;
  position.name = name;
  position.grid = std::make_shared<itk::FlatColonGrid>(flattubes::MakeFlatTube(form, [&](double u, double angle) {
    double depth = 0.0;
    for (const itk::CylinderPlace & place : places)
    {
      const double around = itk::TurnDifference(angle / (2.0 * pi), place.turn) * form.circumference;
      const double along = (u - place.s) / 2.5;
      depth = std::max(depth, 5.0 * std::exp(-along * along) / (1.0 + std::exp((std::abs(around) - 17.0) / 1.5)));
    }
    return flattubes::OnCylinder(radius - depth, u, -angle);
  }));
  for (const itk::CylinderPlace & place : places)
  {
    itk::HaustralFold fold;
    const auto        uvAt = [&](double turn) {
      return Eigen::Vector2d(place.s, (turn - std::floor(turn)) * form.circumference);
    };
    fold.centreUv = uvAt(place.turn);
    fold.endUv = { uvAt(place.turn - 0.13), uvAt(place.turn + 0.13) };
    fold.length = 34.0;
    fold.area = 150.0;
    position.folds.push_back(fold);
  }
  for (int taenia = 0; taenia < 3; ++taenia)
  {
    std::vector<int> curve;
    for (int i = 0; i <= 60; ++i)
    {
      const double u = 5.0 + (length - 10.0) * i / 60.0;
      curve.push_back(static_cast<int>(position.taeniae.V.rows()));
      position.taeniae.V.conservativeResize(curve.back() + 1, 3);
      const double turn = (isReversed ? -1.0 : 1.0) * (taenia / 3.0 + movement.rotation);
      position.taeniae.V.row(curve.back()) = flattubes::OnCylinder(radius, u, -2.0 * pi * turn);
    }
    position.taeniae.curves.push_back(curve);
  }
  for (int flexure = 0; flexure < 4; ++flexure)
  {
    const double s = 10.0 + movement.S(length * (flexure + 1) / 5.0); // the test tubes count from 10 mm
    position.flexures[flexure] = s;
  }
  return position;
}

Movement
SomeMovement()
{
  return { 0.37, 8.0 };
}

/** Errors of the map in mm of the flat map at places all over the tube. */
double
GreatestError(const itk::SupineProneRegistration & registration, const Movement & movement)
{
  const double circumference = 2.0 * pi * radius;
  double       greatest = 0.0;
  for (double s = 40.0; s < length - 40.0; s += 13.0)
  {
    for (double turn = 0.03; turn < 1.0; turn += 0.11)
    {
      const itk::CylinderPlace goal = movement({ s, turn });
      const Eigen::Vector2d    uv = itk::MapUv(registration, { s, turn * circumference });
      greatest = std::max(
        greatest, std::hypot(uv.x() - goal.s, itk::TurnDifference(uv.y() / circumference, goal.turn) * circumference));
    }
  }
  return greatest;
}
} // namespace

TEST(SupineProneRegistration, FindsAKnownMovement)
{
  const auto registration =
    itk::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, SomeMovement()));
  EXPECT_LT(GreatestError(registration, SomeMovement()), 3.0);
  EXPECT_EQ(registration.figures.flips, 0);
  EXPECT_FALSE(registration.confidence.isFlagged);
  for (const itk::FoldMatch & match : registration.matches)
  {
    EXPECT_EQ(match.source, match.target);
  }
  EXPECT_GT(registration.matches.size(), 0.9 * FoldsOfPatient(1).size());
}

TEST(SupineProneRegistration, ForwardAndInverseAgree)
{
  const auto registration =
    itk::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, SomeMovement()));
  const Eigen::Vector2d uv(200.0, 33.0);
  EXPECT_LT((itk::InverseMapUv(registration, itk::MapUv(registration, uv)) - uv).norm(), 1e-6);
}

TEST(SupineProneRegistration, TwoPatientsAreFlagged)
{
  const auto registration =
    itk::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 2, SomeMovement()));
  EXPECT_TRUE(registration.confidence.isFlagged);
  EXPECT_FALSE(registration.confidence.reasons.empty());
}

TEST(SupineProneRegistration, AColonThatRunsTheOtherWayIsRefused)
{
  try
  {
    itk::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, SomeMovement(), true));
    FAIL();
  }
  catch (const itk::InputError & error)
  {
    EXPECT_NE(std::string(error.what()).find("runs from the caecum to the rectum"), std::string::npos) << error.what();
  }
}

TEST(SupineProneRegistration, WithoutLandmarksOrFoldsThereIsNoMap)
{
  const itk::ColonPosition supine = MakePosition("supine", 1, {});
  itk::ColonPosition       prone = MakePosition("prone", 1, SomeMovement());
  prone.taeniae = {};
  prone.flexures.fill(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(itk::RegisterColonPositions(supine, prone), itk::InputError);
  prone = MakePosition("prone", 1, SomeMovement());
  prone.folds.clear();
  EXPECT_THROW(itk::RegisterColonPositions(supine, prone), itk::InputError);
}

TEST(SupineProneRegistration, ErrorsAreMeasuredAgainstPointsInSpace)
{
  const auto same = itk::RegisterColonPositions(MakePosition("supine", 1, {}), MakePosition("prone", 1, {}));
  std::vector<itk::PointPair> pairs;
  for (double u = 50.0; u < 550.0; u += 10.0)
  {
    const Eigen::Vector3d point = flattubes::OnCylinder(radius, u, 0.0); // on a taenia, where no fold stands
    pairs.push_back({ point, point });
  }
  pairs.push_back({ Eigen::Vector3d(500.0, 0.0, 0.0), Eigen::Vector3d(500.0, 0.0, 0.0) });
  const itk::RegistrationErrors errors = itk::MeasureRegistrationErrors(same, pairs);
  EXPECT_EQ(errors.offSurface, 1);
  EXPECT_EQ(errors.inSpace.size(), 50U);
  EXPECT_LT(errors.Mean(), 1.0);
  EXPECT_EQ(errors.ShareWithin10(), 1.0);
}
