#include "shapetonSegmentQuality.h"

#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonTestImages.h"
#include "shapetonTestSurfaces.h"

#include "gtest/gtest.h"

using namespace shapeton;

namespace
{
constexpr double radius = 20.0, length = 300.0, border = 100.0; // mm
constexpr double poolBegin = 110.0;                             // mm
constexpr double level = -5.0;                                  // mm: y of the fluid level

/** The axis of the tube, with a point every 5 mm; the caliber is 40 mm, or 8 mm between 60 and 70 mm. */
CurveSet
Axis()
{
  constexpr int   points = 61;
  Eigen::VectorXd arc = Eigen::VectorXd::LinSpaced(points, 0.0, length);
  Eigen::VectorXd radii =
    (arc.array() > 59.0 && arc.array() < 71.0).select(4.0, Eigen::VectorXd::Constant(points, 20.0));
  CurveSet curve;
  curve.V = VertexMatrix::Zero(points, 3);
  curve.V.col(2) = arc;
  curve.curves.emplace_back();
  for (int i = 0; i < points; ++i)
  {
    curve.curves[0].push_back(i);
  }
  curve.pointArrays = { { "arcLength", arc }, { "radius", radii }, { "gap", Eigen::VectorXd::Zero(points) } };
  return curve;
}

/** Rectum below z = 100 mm, sigmoid above. */
SurfaceMesh
Tube()
{
  SurfaceMesh  tube = testsurfaces::Cylinder(120, 150, radius, length);
  SurfaceArray segment{ "segment", SurfaceArray::ValueMatrix(tube.F.rows(), 1), true };
  for (int face = 0; face < tube.NumberOfFaces(); ++face)
  {
    segment.values(face, 0) = tube.V(tube.F(face, 0), 2) < border ? 1 : 2;
  }
  tube.cellArrays.push_back(segment);
  return tube;
}

/** An oblique, anisotropic image of the lumen: gas; in the sigmoid, fluid below y = -5 mm. */
LumenMask::Pointer
Lumen()
{
  const auto image = basetest::NewImage<LumenMask>(
    { { 60, 60, 170 } }, { 1.0, 1.2, 2.0 }, { -18.0, -43.0, -20.0 }, basetest::Rotation(2, 0.3));
  basetest::Sample(image.GetPointer(), [](const auto & p) {
    const bool isLumen = std::hypot(p[0], p[1]) < radius && p[2] > 0.0 && p[2] < length;
    return !isLumen ? 0 : p[2] > poolBegin && p[1] < level ? 2 : 1;
  });
  return image;
}
} // namespace

TEST(SegmentQuality, StatesWhatIsKnownOfATube)
{
  const auto          lumen = Lumen();
  const CurveSet      axis = Axis();
  const SurfaceMesh   tube = Tube();
  SegmentQualityInput input;
  input.centerline = &axis;
  input.wall = &tube;
  input.segments = { { 1, "rectum", 0.0, border, 0.0 }, { 2, "sigmoid", border, length, 25000.0 } };
  input.hidden = { { { 0.0, 25.0, 250.0 }, 300.0 }, { { 0.0, -25.0, 150.0 }, 20.0 } };
  input.lumen = lumen;
  input.attenuation = [](const Eigen::Vector3d & p) {
    const double r = std::hypot(p.x(), p.y());
    const bool   isFilm =
      r >= radius && r < radius + 1.2 && std::abs(p.y()) < 0.5 * p.x() && std::abs(p.z() - 50.0) < 10.0;
    return r < radius ? (p.y() < level ? 700.0 : -1000.0) : isFilm ? 450.0 : 40.0;
  };
  const std::vector<SegmentQuality> rows = MeasureSegmentQuality(input);
  ASSERT_EQ(rows.size(), 2u);

  // The rectum, excluding the anal canal, extends from 40 to 100 mm; the steps from 60 to 70 mm have a caliber of 8 mm,
  // those next to them 24 mm.
  EXPECT_DOUBLE_EQ(rows[0].distension.begin, AnalCanalLength);
  EXPECT_DOUBLE_EQ(rows[0].distension.leastCaliber, 8.0);
  EXPECT_DOUBLE_EQ(rows[0].distension.share, 50.0 / 60.0);
  EXPECT_EQ(rows[0].grade, DistensionGrade::Inadequate);
  EXPECT_EQ(rows[0].submergedShare, 0.0);
  EXPECT_TRUE(std::isnan(rows[0].fluidAttenuation));
  EXPECT_NEAR(rows[0].residueArea, 20.0 * radius * 2.0 * std::atan(0.5), 15.0); // a third of a ring of triangles
  EXPECT_EQ(rows[0].hiddenParts, 0);
  double                       coatedArea = 0.0;
  const std::vector<WallCover> covers = FindWallCovers(tube, lumen, input.attenuation);
  for (int f = 0; f < tube.NumberOfFaces(); ++f)
  {
    const Eigen::Vector3d a = tube.V.row(tube.F(f, 0)), b = tube.V.row(tube.F(f, 1)), c = tube.V.row(tube.F(f, 2));
    coatedArea += covers[static_cast<std::size_t>(f)] == WallCover::Residue ? 0.5 * (b - a).cross(c - a).norm() : 0.0;
  }
  EXPECT_NEAR(coatedArea, rows[0].residueArea, 1e-9);

  EXPECT_EQ(rows[1].grade, DistensionGrade::Optimal);
  const double wetLength = (length - poolBegin) / (length - border);
  EXPECT_NEAR(rows[1].submergedShare, wetLength * std::acos(5.0 / 18.0) / Pi, 0.02); // of a circle 2 mm inside
  EXPECT_NEAR(rows[1].fluidAttenuation, 700.0, 1e-9);
  EXPECT_EQ(rows[0].seamArea, 0.0);
  EXPECT_EQ(rows[1].residueArea, 0.0);
  // Two strips above and below the level on a circle 2 mm inside, and a ring where the pool begins. The reach of 2.5 mm
  // is blurred by voxels of 1 to 2 mm.
  const auto seam = [](double reach) {
    const double around = std::asin((level + reach) / 18.0) - std::asin((level - reach) / 18.0);
    const double wet = 2.0 * std::acos(-level / 18.0);
    return 2.0 * around * radius * (length - poolBegin) + wet * radius * 2.0 * reach;
  };
  EXPECT_GT(rows[1].seamArea, seam(2.0));
  EXPECT_LT(rows[1].seamArea, seam(3.0));
  EXPECT_DOUBLE_EQ(rows[1].hiddenArea, 320.0);
  EXPECT_EQ(rows[1].hiddenParts, 2);
  EXPECT_EQ(rows[1].largestHidden.place.z(), 250.0);
  EXPECT_DOUBLE_EQ(rows[1].EvaluableShare(), 1.0 - (320.0 + rows[1].seamArea) / 25000.0);
}

TEST(SegmentQuality, MarksWallAboveWeaklyTaggedFluid)
{
  const auto        lumen = Lumen();
  const SurfaceMesh tube = Tube();
  // A strip 3.5 mm deep behind the bottom of the pool, and beside it one of 1 mm, the blur of a wall.
  const auto attenuation = [](const Eigen::Vector3d & p) {
    const double r = std::hypot(p.x(), p.y());
    const bool   isBottom = p.y() < -0.9 * radius && r >= radius;
    const double depth = p.z() > 250.0 ? 3.5 : 1.0;
    return isBottom && r < radius + depth ? 284.0 : r >= radius ? 40.0 : p.y() < level ? 700.0 : -1000.0;
  };
  const std::vector<WallCover> covers = FindWallCovers(tube, lumen, attenuation);
  for (int f = 0; f < tube.NumberOfFaces(); ++f)
  {
    const Eigen::Vector3d middle =
      (tube.V.row(tube.F(f, 0)) + tube.V.row(tube.F(f, 1)) + tube.V.row(tube.F(f, 2))) / 3.0;
    const bool isInStrip = middle.z() > 255.0 && middle.z() < length - 5.0 && middle.y() < -0.95 * radius;
    const bool isOutside = middle.z() < 245.0 || middle.y() > -0.85 * radius;
    const bool isMarked = covers[static_cast<std::size_t>(f)] == WallCover::Residue;
    EXPECT_TRUE(!isInStrip || isMarked) << middle.transpose();
    EXPECT_TRUE(!isOutside || !isMarked) << middle.transpose();
  }
}

TEST(SegmentQuality, LeavesOutWhatNeedsImages)
{
  const CurveSet      axis = Axis();
  SurfaceMesh         tube = Tube();
  SegmentQualityInput input;
  input.centerline = &axis;
  input.wall = &tube;
  input.segments = { { 2, "sigmoid", border, length, 0.0 } };
  const std::vector<SegmentQuality> rows = MeasureSegmentQuality(input);
  EXPECT_TRUE(std::isnan(rows.at(0).submergedShare) && std::isnan(rows[0].residueArea));
  const CsvTable table = TableOfSegmentQuality(rows);
  EXPECT_EQ(table.GetRows().at(0).at(3), "optimal");
  EXPECT_EQ(table.GetColumns().at(11), "submergedShare");
  EXPECT_EQ(table.GetRows()[0].at(11), "");
  tube.cellArrays.clear();
  EXPECT_THROW(MeasureSegmentQuality(input), InputError);
}

TEST(SegmentQuality, GradesByCaliber)
{
  const auto grade = [](double share, double caliber) {
    ColonDistension distension;
    distension.share = share;
    distension.meanCaliber = caliber;
    return NameOf(GradeOf(distension));
  };
  EXPECT_EQ(grade(1.0, 30.0), "optimal");
  EXPECT_EQ(grade(0.95, 15.0), "adequate");
  EXPECT_EQ(grade(0.7, 30.0), "inadequate");
  EXPECT_EQ(grade(0.4, 30.0), "collapsed");
}
