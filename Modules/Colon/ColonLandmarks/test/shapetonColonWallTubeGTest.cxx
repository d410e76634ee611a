#include "shapetonColonWallTube.h"

#include "shapetonLandmarkTubes.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

using landmarktubes::StraightLine;
using shapeton::ColonWallTube;

namespace
{
constexpr double length = 150.0;

shapeton::SurfaceMesh
Cylinder(double sway = 1.0)
{
  flattubes::TubeForm form;
  form.length = length;
  form.cutSway = sway;
  return flattubes::MakeCylinder(form);
}

/** Message of an InputError. */
std::string
MessageOf(const shapeton::SurfaceMesh & flat, const shapeton::CurveSet & centerline)
{
  return basetest::ErrorOf([&] { const ColonWallTube tube(shapeton::FlatColon(flat), centerline); });
}
} // namespace

TEST(ColonWallTube, HasOneVertexForEachPlaceOfTheCut)
{
  const shapeton::SurfaceMesh flat = Cylinder();
  const ColonWallTube         tube(shapeton::FlatColon(flat), StraightLine(length));
  EXPECT_EQ(tube.NumberOfVertices(), 48 * 61);
  EXPECT_EQ(tube.Faces().rows(), flat.F.rows());
  EXPECT_EQ(tube.Connectivity().BoundaryLoops().size(), 2u);
  for (int i = 0; i < flat.NumberOfVertices(); ++i)
  {
    ASSERT_EQ(tube.Points().row(tube.VertexOfFlat(i)), flat.V.row(i));
  }
}

TEST(ColonWallTube, CountsTheTurnsOfWalks)
{
  const ColonWallTube tube(shapeton::FlatColon(Cylinder()), StraightLine(length));
  for (const std::vector<int> & loop : tube.Connectivity().BoundaryLoops())
  {
    int turns = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int next = loop[(i + 1) % loop.size()];
      turns += tube.Turns(loop[i], next);
      EXPECT_EQ(tube.Turns(loop[i], next), -tube.Turns(next, loop[i]));
    }
    EXPECT_EQ(std::abs(turns), 1);
  }
  for (int face = 0; face < tube.Faces().rows(); ++face)
  {
    const auto corners = tube.Faces().row(face);
    ASSERT_EQ(
      tube.Turns(corners[0], corners[1]) + tube.Turns(corners[1], corners[2]) + tube.Turns(corners[2], corners[0]), 0);
  }
}

TEST(ColonWallTube, KnowsTheDistanceAlongTheCenterline)
{
  const SchematicColon colon = MakeSchematicColon();
  const ColonWallTube  tube(shapeton::FlatColon(landmarktubes::TubeAlong(colon.centerline, 12.0)), colon.centerline);
  for (int vertex = 0; vertex < tube.NumberOfVertices(); vertex += 7)
  {
    const Eigen::Index i = static_cast<Eigen::Index>(tube.Uv(vertex).x());
    ASSERT_NEAR(tube.ArcLength(vertex), colon.centerline.pointArrays[0].values(i, 0), 30.0); // inside of a hairpin bend
  }
}

TEST(ColonWallTube, RefusesACenterlineFromItsOtherEnd)
{
  const SchematicColon        colon = MakeSchematicColon();
  const shapeton::SurfaceMesh flat = landmarktubes::TubeAlong(colon.centerline, 12.0);
  EXPECT_EQ(MessageOf(flat, colon.centerline), "");
  EXPECT_NE(MessageOf(flat, ReversedCurve(colon.centerline)).find("from the cecum to the rectum"), std::string::npos);
}

TEST(ColonWallTube, RefusesTheCenterlineOfAnotherColon)
{
  SchematicColon              colon = MakeSchematicColon();
  const shapeton::SurfaceMesh flat = landmarktubes::TubeAlong(colon.centerline, 12.0);
  colon.centerline.V.col(0) *= 0.7;
  EXPECT_NE(MessageOf(flat, colon.centerline).find("different colons or positions"), std::string::npos);
}

TEST(ColonWallTube, TakesACenterlineOfAPartWithAWarning)
{
  const SchematicColon colon = MakeSchematicColon();
  shapeton::CurveSet   part;
  part.V = colon.centerline.V.middleRows(300, 400);
  part.curves.emplace_back();
  shapeton::SurfaceArray arc{ "arcLength", colon.centerline.pointArrays[0].values.middleRows(300, 400), false };
  part.pointArrays.push_back(arc);
  for (int i = 0; i < 400; ++i)
  {
    part.curves[0].push_back(i);
  }
  const ColonWallTube tube(shapeton::FlatColon(landmarktubes::TubeAlong(colon.centerline, 12.0)), part);
  ASSERT_EQ(tube.Warnings().size(), 1u);
  EXPECT_NE(tube.Warnings()[0].find("a part of the flat surface"), std::string::npos);
}

TEST(ColonWallTube, RefusesASurfaceThatIsNotFlat)
{
  shapeton::SurfaceMesh flat = Cylinder();
  flat.pointArrays.clear();
  EXPECT_NE(MessageOf(flat, StraightLine(length)).find("uv"), std::string::npos);
}
