#include "shapetonColonSegments.h"

#include "shapetonIleocecalValve.h"
#include "shapetonLandmarkTubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using shapeton::ColonSegments;
using shapeton::ColonWallTube;

namespace
{
constexpr double radius = 12.0;

struct LabeledColon
{
  SchematicColon colon{ MakeSchematicColon() };
  ColonWallTube  tube{ shapeton::FlatColon(landmarktubes::TubeAlong(colon.centerline, radius)), colon.centerline };
  shapeton::ColonFlexures flexures{ shapeton::FindColonFlexures(colon.centerline) };
};

double
ArcLengthOfFace(const ColonWallTube & tube, int face)
{
  const auto corners = tube.Faces().row(face);
  return (tube.ArcLength(corners[0]) + tube.ArcLength(corners[1]) + tube.ArcLength(corners[2])) / 3.0;
}
} // namespace

TEST(FlexureLoops, RunOnceAroundInThePlane)
{
  flattubes::TubeForm form;
  form.cutSway = 1.0;
  const ColonWallTube         tube(shapeton::FlatColon(flattubes::MakeCylinder(form)),
                           landmarktubes::StraightLine(form.length));
  const shapeton::SurfaceWalk loop = shapeton::FindLoop(tube, { 0, 0, 70.0 }, Eigen::Vector3d::UnitZ(), 70.0);
  const std::vector<int> &    vertices = loop.vertices;
  ASSERT_GE(vertices.size(), 48u);
  int turns = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    ASSERT_GE(tube.Connectivity().FindEdge(vertices[i], vertices[(i + 1) % vertices.size()]), 0);
    turns += tube.Turns(vertices[i], vertices[(i + 1) % vertices.size()]);
    EXPECT_NEAR(tube.Points()(vertices[i], 2), 70.0, 2.6);
  }
  EXPECT_EQ(std::abs(turns), 1);
  EXPECT_NEAR(loop.length, form.circumference, 0.12 * form.circumference);
  EXPECT_EQ(std::set<int>(vertices.begin(), vertices.end()).size(), vertices.size());
}

TEST(FlexureLoops, AreEmptyWhereThereIsNoWall)
{
  flattubes::TubeForm form;
  const ColonWallTube tube(shapeton::FlatColon(flattubes::MakeCylinder(form)),
                           landmarktubes::StraightLine(form.length));
  EXPECT_TRUE(shapeton::FindLoop(tube, { 0, 0, 900.0 }, Eigen::Vector3d::UnitZ(), 900.0).vertices.empty());
}

TEST(ColonSegments, LieBetweenTheFlexures)
{
  const LabeledColon  c;
  const ColonSegments segments = FindColonSegments(c.tube, c.colon.centerline, c.flexures);
  ASSERT_EQ(segments.borders.size(), 5u);
  EXPECT_TRUE(segments.warnings.empty());
  for (int face = 0; face < c.tube.Faces().rows(); ++face)
  {
    const double arc = ArcLengthOfFace(c.tube, face);
    int          expected = 1;
    double       nearest = 1e9;
    for (const shapeton::SegmentBorder & border : segments.borders)
    {
      expected += arc > border.arcLength ? 1 : 0;
      nearest = std::min(nearest, std::abs(arc - border.arcLength));
    }
    // At a bend, the positions given by the cross-section plane and by the nearest point of the line differ by up to
    // the radius.
    if (nearest > 1.5 * radius)
    {
      ASSERT_EQ(segments.segmentOfFace[face], expected) << arc;
    }
  }
}

TEST(ColonSegments, BesideAMissingFlexureAreUnknown)
{
  LabeledColon c;
  c.flexures.flexures[1].isFound = false;
  const ColonSegments segments = FindColonSegments(c.tube, c.colon.centerline, c.flexures);
  const auto count = [&](int s) { return std::count(segments.segmentOfFace.begin(), segments.segmentOfFace.end(), s); };
  EXPECT_GT(count(0), 0);
  EXPECT_GT(count(1), 0);
  EXPECT_EQ(count(2), 0);
  EXPECT_EQ(count(3), 0);
  EXPECT_GT(count(4), 0);
  ASSERT_EQ(segments.warnings.size(), 1u);
  EXPECT_NE(segments.warnings[0].find("is unknown"), std::string::npos);
}

TEST(ColonSegments, PlaceTheCecumSixCentimetersFromTheEnd)
{
  const LabeledColon              c;
  const ColonSegments             segments = FindColonSegments(c.tube, c.colon.centerline, c.flexures);
  const shapeton::SegmentBorder & cecum = segments.borders.back();
  EXPECT_EQ(cecum.number, 5);
  const Eigen::Vector3d end = c.colon.centerline.V.bottomRows(1).transpose();
  EXPECT_NEAR((cecum.point - end).norm(), 60.0, 4.5); // the line is sampled every 2 mm
}

TEST(ColonSegments, EndTheCecumAtAKnownValve)
{
  LabeledColon             c;
  shapeton::IleocecalValve valve;
  valve.arcLength = shapeton::PointValues(c.colon.centerline, "arcLength", "the line").maxCoeff() - 80.0;
  valve.confidence = 0.8;
  shapeton::SetIleocecalValve({ valve, "", {} }, c.colon.centerline);
  const ColonSegments segments = FindColonSegments(c.tube, c.colon.centerline, c.flexures);
  EXPECT_TRUE(segments.isCecumAtValve);
  EXPECT_EQ(segments.borders.back().number, 5);
  EXPECT_NEAR(segments.borders.back().arcLength, valve.arcLength, 1.0);
  EXPECT_EQ(segments.borders.back().confidence, 0.8);
}

TEST(ColonSegments, HaveNames)
{
  EXPECT_EQ(shapeton::NameOfSegment(0), "unknown");
  EXPECT_EQ(shapeton::NameOfSegment(6), "cecum");
  EXPECT_EQ(shapeton::NameOfSegment(7), "");
  EXPECT_EQ(shapeton::NameOfFlexure(3), "splenic");
  EXPECT_EQ(shapeton::NameOfFlexure(0), "");
}
