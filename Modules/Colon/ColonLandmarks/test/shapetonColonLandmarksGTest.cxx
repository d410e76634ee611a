#include "shapetonColonSplitting.h"
#include "shapetonProgressTests.h"

#include "shapetonJson.h"
#include "shapetonLandmarkTubes.h"

#include <gtest/gtest.h>

namespace
{
using shapeton::ColonLandmarks;
using shapeton::ColonWallTube;

constexpr double radius = 120.0 / (2.0 * landmarktubes::pi);
constexpr double length = 150.0;

shapeton::SegmentBorder
BorderAt(const ColonWallTube & tube, int number, double z)
{
  shapeton::SegmentBorder border;
  border.number = number;
  border.arcLength = z;
  border.point = { 0.0, 0.0, z };
  border.loop = shapeton::FindLoop(tube, border.point, Eigen::Vector3d::UnitZ(), z);
  return border;
}

/** A cylinder with a straight taenia and labels for rectum, sigmoid and descending colon. */
ColonLandmarks
LandmarksOfCylinder(const shapeton::SurfaceMesh & flat)
{
  ColonLandmarks landmarks;
  landmarks.tube =
    std::make_shared<const ColonWallTube>(shapeton::FlatColon(flat), landmarktubes::StraightLine(length));
  landmarks.segments.borders = { BorderAt(*landmarks.tube, 1, 40.0), BorderAt(*landmarks.tube, 2, 100.0) };
  for (int face = 0; face < flat.NumberOfFaces(); ++face)
  {
    const double z = (flat.V(flat.F(face, 0), 2) + flat.V(flat.F(face, 1), 2) + flat.V(flat.F(face, 2), 2)) / 3.0;
    landmarks.segments.segmentOfFace.push_back(z < 40.0 ? 1 : z < 100.0 ? 2 : 0);
  }
  shapeton::ColonTaenia taenia;
  for (double z = 0.0; z <= length; z += 2.0)
  {
    taenia.points.emplace_back(0.0, radius, z);
    taenia.arcLength.push_back(z);
  }
  landmarks.taeniae.taeniae = { taenia, taenia, taenia };
  return landmarks;
}
} // namespace

// The modulus of the rectangle is circumference / length.
TEST(ColonSplitting, OfACylinderHasTheModulusOfItsRectangles)
{
  flattubes::TubeForm form;
  form.length = length;
  const shapeton::SurfaceMesh flat = flattubes::MakeCylinder(form);
  const shapeton::ColonPieces pieces = SplitColon(flat, LandmarksOfCylinder(flat));
  ASSERT_EQ(pieces.pieces.size(), 2u);
  EXPECT_EQ(pieces.warnings.size(), 4u); // for the missing segments
  const double lengths[] = { 40.0, 60.0 };
  for (int i = 0; i < 2; ++i)
  {
    const shapeton::ColonPiece & piece = pieces.pieces[i];
    EXPECT_EQ(piece.name, shapeton::NameOfSegment(i + 1));
    const double modulus = std::sqrt(piece.modulusU * piece.modulusV);
    EXPECT_NEAR(modulus, 120.0 / lengths[i], 0.03 * modulus);
    EXPECT_GE(piece.modulusU, piece.modulusV * (1.0 - 1e-9));
    EXPECT_NEAR(piece.width, lengths[i], 0.03 * lengths[i]);
    EXPECT_EQ(piece.flips, 0);
    EXPECT_NEAR(piece.area, 120.0 * lengths[i], 0.01 * piece.area);
    const shapeton::SurfaceArray * uv = shapeton::FindSurfaceArray(piece.flat.pointArrays, "uv");
    ASSERT_NE(uv, nullptr);
    for (int v = 0; v < piece.flat.NumberOfVertices(); ++v)
    {
      ASSERT_NEAR(uv->values(v, 0), piece.flat.V(v, 2) - 40.0 * i, 2.5) << "the rectal end is at the left";
    }
  }
}

TEST(ColonSplitting, NeedsATaenia)
{
  const shapeton::SurfaceMesh flat = flattubes::MakeCylinder({});
  ColonLandmarks              landmarks = LandmarksOfCylinder(flat);
  landmarks.taeniae.taeniae.clear();
  const shapeton::ColonPieces pieces = SplitColon(flat, landmarks);
  EXPECT_TRUE(pieces.pieces.empty());
  EXPECT_EQ(pieces.warnings.size(), 1u);
}

TEST(ColonLandmarks, AreFoundTogetherAndToldInJson)
{
  const SchematicColon        colon = MakeSchematicColon();
  const shapeton::SurfaceMesh flat = landmarktubes::TubeAlong(colon.centerline, 12.0);
  const ColonLandmarks        landmarks = shapeton::FindColonLandmarks(shapeton::FlatColon(flat), colon.centerline);
  EXPECT_EQ(landmarks.segments.borders.size(), 5u);
  EXPECT_TRUE(landmarks.taeniae.taeniae.empty()); // a smooth tube has no folds
  const shapeton::Json json = ColonLandmarksToJson(landmarks);
  ASSERT_EQ(json["flexures"].size(), 4u);
  for (const shapeton::Json & flexure : json["flexures"])
  {
    EXPECT_TRUE(flexure["found"]);
    EXPECT_EQ(flexure["position"].size(), 3u);
    EXPECT_EQ(flexure["uv"].size(), 2u);
  }
  EXPECT_EQ(json["segments"].size(), 6u);
  EXPECT_EQ(json["taeniae"]["found"], 0);
  EXPECT_FALSE(json["taeniae"]["reason"].empty());

  const shapeton::CurveSet loops = FlexureCurves(landmarks);
  ASSERT_EQ(loops.curves.size(), 4u);
  for (const std::vector<int> & loop : loops.curves)
  {
    EXPECT_EQ(loop.front(), loop.back());
  }
  EXPECT_EQ(shapeton::FindSurfaceArray(SegmentSurface(flat, landmarks).cellArrays, "segment")->values.rows(),
            flat.NumberOfFaces());
}

TEST(ColonLandmarks, SegmentsAndBordersTellWhereTheWallIsNotSeen)
{
  flattubes::TubeForm form;
  form.length = length;
  ColonLandmarks landmarks = LandmarksOfCylinder(flattubes::MakeCylinder(form));
  EXPECT_FALSE(shapeton::AssessabilityOfSegment(landmarks, 2));
  landmarks.hindered = { { 10.0, 14.0, shapeton::ColonHindrance::Narrow },
                         { 70.0, 105.0, shapeton::ColonHindrance::UntaggedFluid } };
  landmarks.lengthOfCenterline = length;
  landmarks.taeniae = {}; // taeniae without confidence
  EXPECT_NEAR(shapeton::AssessabilityOfSegment(landmarks, 1)->share, 0.9, 1e-12);
  EXPECT_EQ(shapeton::AssessabilityOfSegment(landmarks, 2)->Verdict(), "partly");
  EXPECT_FALSE(shapeton::AssessabilityOfSegment(landmarks, 3)); // its end is unknown
  const shapeton::Json json = shapeton::ColonLandmarksToJson(landmarks);
  EXPECT_EQ(json["notAssessable"].size(), 2u);
  EXPECT_EQ(json["segmentsNotFound"], shapeton::Json({ "descending", "transverse", "ascending", "cecum" }));
  for (const shapeton::Json & segment : json["segments"])
  {
    EXPECT_EQ(segment.contains("verdict"), segment["number"] != 0);
    if (segment["number"] == 2)
    {
      EXPECT_EQ(segment["assessableShare"], 0.5);
      EXPECT_EQ(segment["reasons"][0]["reason"], "untaggedFluid");
      EXPECT_EQ(segment["reasons"][0]["length"], 30.0);
    }
  }
}

TEST(ColonLandmarks, AreNotFoundAfterAnAbort)
{
  const SchematicColon      colon = MakeSchematicColon();
  const shapeton::FlatColon flat(landmarktubes::TubeAlong(colon.centerline, 12.0));
  const auto                work = [&](const shapeton::Progress & progress) {
    shapeton::ColonLandmarkSettings options;
    options.progress = progress;
    FindColonLandmarks(flat, colon.centerline, options);
  };
  shapeton::test::ExpectProgress(work, 100); // including one call per possible start of a loop
}
