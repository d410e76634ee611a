#include "shapetonColonWall.h"
#include "shapetonLumenAlong.h"
#include "shapetonLumenShapes.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceSmoothing.h"
#include "shapetonExceptions.h"
#include "shapetonTestImages.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lumenshapes;

namespace
{
constexpr double TubeLength = 80;
constexpr double TubeRadius = 12;
const Points     TubeAxis = Line({ 0, 0, 0 }, { 0, 0, TubeLength });

shapeton::OccupancyImage::Pointer
TubeOccupancy(const Grid & grid = {})
{
  return Occupancy(Tube({ TubeAxis.front(), TubeAxis.back() }, TubeRadius), BoxOf(TubeAxis, TubeRadius), grid);
}

/** A mask of the voxels that are at least half in the lumen. */
shapeton::LumenMaskImage::Pointer
MaskOf(const shapeton::OccupancyImage::Pointer & occupancy, unsigned char value)
{
  return shapeton::MapVoxels<unsigned char>(occupancy.GetPointer(),
                                            [value](float share) { return share >= 0.5F ? value : 0; });
}

/** The axis of a wide leg 1 mm from a narrow one; the wall of the wide leg is closer to the axis of the narrow one. */
Points
TwoLegs()
{
  Points axis = Line({ 0, 0, 0 }, { 0, 0, 50 });
  for (const Points & part : { Line({ 1, 0, 50 }, { 19, 0, 50 }), Line({ 19, 0, 49 }, { 19, 0, 0 }) })
  {
    axis.insert(axis.end(), part.begin(), part.end());
  }
  return axis;
}

shapeton::OccupancyImage::Pointer
OccupancyOfTwoLegs(const Points & axis)
{
  const Depth lumen = Union(Tube({ { 0, 0, 0 }, { 0, 0, 50 } }, 14), Tube(axis, 4));
  return Occupancy(lumen, BoxOf(axis, 14), ObliqueGrid(true), 2.0);
}

/** Two tubes separated by a gap of 20 mm. */
shapeton::OccupancyImage::Pointer
BrokenTube(const Grid & grid = {})
{
  const Depth lumen = Union(Tube({ { 0, 0, 0 }, { 0, 0, 40 } }, 10), Tube({ { 0, 0, 80 }, { 0, 0, 120 } }, 10));
  return Occupancy(lumen, BoxOf({ { 0, 0, 0 }, { 0, 0, 120 } }, 10), grid);
}

shapeton::CurveSet
BrokenCenterline()
{
  return Centerline(Line({ 0, 0, 0 }, { 0, 0, 120 }), [](const Eigen::Vector3d & p) { return p[2] > 49 && p[2] < 71; });
}

Eigen::VectorXd
Field(const shapeton::SurfaceMesh & mesh, const char * name)
{
  const shapeton::SurfaceArray * array = shapeton::FindSurfaceArray(mesh.fieldArrays, name);
  EXPECT_NE(nullptr, array) << name;
  return array == nullptr ? Eigen::VectorXd() : Eigen::VectorXd(array->values.col(0));
}

void
ExpectLoopsAtBoundary(const shapeton::SurfaceMesh & mesh)
{
  const shapeton::SurfaceConnectivity connectivity(mesh);
  for (const char * name : { "rectumLoop", "cecumLoop" })
  {
    const Eigen::VectorXd loop = Field(mesh, name);
    ASSERT_GT(loop.size(), 3);
    for (Eigen::Index i = 0; i < loop.size(); ++i)
    {
      const int edge = connectivity.FindEdge(static_cast<int>(loop[i]), static_cast<int>(loop[(i + 1) % loop.size()]));
      ASSERT_GE(edge, 0);
      EXPECT_TRUE(connectivity.IsBoundaryEdge(edge));
    }
  }
}

/** Expects one manifold component with a `rectumLoop` near z = 0 and a `cecumLoop` near z = far. */
void
ExpectOpenEnds(const shapeton::SurfaceMesh & mesh, int genus)
{
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(mesh);
  EXPECT_EQ(1U, quality.components.size());
  EXPECT_EQ(2U, quality.boundaryLoopLengths.size());
  EXPECT_TRUE(quality.isManifold);
  EXPECT_TRUE(quality.isOriented);
  EXPECT_EQ(genus, quality.genus.value_or(-1));
  EXPECT_TRUE(quality.defects.AreNone());
  ExpectLoopsAtBoundary(mesh);
}

Eigen::Vector3d
CenterOfLoop(const shapeton::SurfaceMesh & mesh, const char * name)
{
  const Eigen::VectorXd loop = Field(mesh, name);
  Eigen::Vector3d       sum = Eigen::Vector3d::Zero();
  for (const double vertex : loop)
  {
    sum += mesh.V.row(static_cast<Eigen::Index>(vertex));
  }
  return sum / static_cast<double>(loop.size());
}

/** Maximum distance of the vertices from the wall of a shape. */
double
GreatestError(const shapeton::SurfaceMesh & mesh, const Depth & depth)
{
  double greatest = 0.0;
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    greatest = std::max(greatest, std::abs(depth(mesh.V.row(i))));
  }
  return greatest;
}
} // namespace

TEST(ColonWall, ClosedFormsOnAnyGrid)
{
  const double volume = Pi * TubeRadius * TubeRadius * (TubeLength + 4.0 / 3.0 * TubeRadius);
  const double area = 2.0 * Pi * TubeRadius * (TubeLength + 2.0 * TubeRadius);
  for (const Grid & grid : { Grid(), ObliqueGrid(false), ObliqueGrid(true) })
  {
    const auto mesh = shapeton::ExtractWall(TubeOccupancy(grid));
    EXPECT_TRUE(shapeton::SurfaceConnectivity(mesh).IsClosed());
    EXPECT_TRUE(shapeton::SurfaceConnectivity(mesh).IsOriented());
    EXPECT_NEAR(volume, shapeton::EnclosedVolume(mesh.V, mesh.F), 0.005 * volume); // outward orientation
    EXPECT_NEAR(area, shapeton::SurfaceArea(mesh.V, mesh.F), 0.005 * area);
    EXPECT_GT(0.03, GreatestError(mesh, Tube({ TubeAxis.front(), TubeAxis.back() }, TubeRadius)));
  }
}

TEST(ColonWall, VerticesLieOnTheCrossing)
{
  const auto image = Occupancy(Sphere({ 0, 0, 0 }, 8), BoxOf({ { 0, 0, 0 } }, 8));
  const auto mesh = shapeton::ExtractWall(image);
  // At unit spacing, two coordinates of each vertex are integers; the field is linear along the third.
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
    for (int k = 0; k < 3; ++k)
    {
      const double index = mesh.V(i, k) - image->GetOrigin()[k];
      const bool   isWhole = std::abs(index - std::round(index)) < 1e-4;
      low[k] = isWhole ? std::round(index) : std::floor(index);
      high[k] = isWhole ? std::round(index) : std::floor(index) + 1.0;
    }
    const auto valueAt = [&](const Eigen::Vector3d & p) {
      return image->GetPixel({ { std::lround(p[0]), std::lround(p[1]), std::lround(p[2]) } });
    };
    const Eigen::Vector3d index = mesh.V.row(i).transpose() - Eigen::Vector3d(image->GetOrigin().GetDataPointer());
    const double          length = (high - low).norm();
    ASSERT_LE(length, 1.0 + 1e-9);
    const double share = length > 0.0 ? (index - low).norm() / length : 0.0;
    EXPECT_NEAR(0.5, (1.0 - share) * valueAt(low) + share * valueAt(high), 1e-3);
  }
}

TEST(ColonWall, HandlesOfTheSurfaceAreThoseOfTheShape)
{
  const Depth two = Union(Torus({ -12, 0, 0 }, 12, 5), Torus({ 12, 0, 0 }, 12, 5));
  const auto  occupancy = Occupancy(two, BoxOf({ { -12, 0, 0 }, { 12, 0, 0 } }, 17));
  EXPECT_EQ(2, shapeton::SurfaceConnectivity(shapeton::ExtractWall(occupancy)).Components().front().genus.value());
  const auto mask = shapeton::RepairLumenTopology(occupancy, shapeton::CurveSet()).mask;
  EXPECT_EQ(0,
            shapeton::SurfaceConnectivity(shapeton::ExtractWall(occupancy, mask)).Components().front().genus.value());
  const auto torus = shapeton::ExtractWall(Occupancy(Torus({ 0, 0, 0 }, 12, 5), BoxOf({ { 0, 0, 0 } }, 17)));
  EXPECT_NEAR(2.0 * Pi * Pi * 12 * 25, shapeton::EnclosedVolume(torus.V, torus.F), 60);
}

TEST(ColonWall, ClampingMovesOnlyWhatTheMaskChanges)
{
  const Depth whole = Sphere({ 0, 0, 0 }, 10);
  const auto  occupancy = Occupancy(Without(whole, Sphere({ 0, 0, 0 }, 3)), BoxOf({ { 0, 0, 0 } }, 10));
  const auto  mask = shapeton::RepairLumenTopology(occupancy, shapeton::CurveSet()).mask;
  const auto  mesh = shapeton::ExtractWall(occupancy, mask);
  EXPECT_GT(0.05, GreatestError(mesh, whole)); // the cavity is filled, the outer wall unchanged
  auto other = basetest::NewImage<shapeton::LumenMaskImage>({ { 3, 3, 3 } });
  EXPECT_THROW(shapeton::ExtractWall(occupancy, other), std::invalid_argument);
}

TEST(ColonWall, RefusesAnEmptyField)
{
  const auto occupancy = Occupancy([](const Eigen::Vector3d &) { return -9.0; }, BoxOf({ { 0, 0, 0 } }, 4));
  EXPECT_THROW(shapeton::ExtractWall(occupancy), shapeton::InputError);
}

TEST(ColonWall, SmoothingKeepsItsLimitsAndShapesTriangles)
{
  const auto                        mesh = shapeton::ExtractWall(TubeOccupancy(ObliqueGrid(false)));
  shapeton::SurfaceSmoothingOptions options;
  options.normalLimit = 0.1;
  options.tangentialLimit = 0.4;
  const auto smooth = shapeton::SmoothSurface(mesh, options);
  EXPECT_GE(std::hypot(0.1, 0.4) + 1e-9, (smooth.V - mesh.V).rowwise().norm().maxCoeff());
  EXPECT_GT(2.0, shapeton::InspectSurface(mesh).smallestAngle.percentile1);
  EXPECT_LT(15.0, shapeton::InspectSurface(smooth).smallestAngle.percentile1);
  EXPECT_GT(0.1, GreatestError(smooth, Tube({ TubeAxis.front(), TubeAxis.back() }, TubeRadius)));
}

TEST(ColonWall, BridgesJoinThePieces)
{
  for (const Grid & grid : { Grid(), ObliqueGrid(true) })
  {
    const auto broken = BrokenTube(grid);
    const auto bridged = shapeton::AddBridges(broken, BrokenCenterline());
    EXPECT_TRUE(bridged.warnings.empty());
    EXPECT_EQ(1, shapeton::RepairLumenTopology(broken, shapeton::CurveSet()).report.droppedPieces);
    EXPECT_EQ(0, shapeton::RepairLumenTopology(bridged.occupancy, BrokenCenterline()).report.droppedPieces);
    const auto   mesh = shapeton::ExtractWall(bridged.occupancy);
    const double piece = Pi * 100 * (40 + 40.0 / 3.0);
    const double tube = Pi * 4 * 20;
    EXPECT_NEAR(2 * piece + tube, shapeton::EnclosedVolume(mesh.V, mesh.F), 0.01 * piece);
  }
}

/** Two cubes share an edge. The interpolated occupancy along the diagonal is at least 0.5. */
TEST(ColonWall, BridgesJoinPiecesThatTouchAtAnEdge)
{
  const auto cubes = basetest::NewImage<shapeton::OccupancyImage>({ { 12, 12, 7 } });
  basetest::Sample(cubes.GetPointer(), [](const auto & point) {
    const auto isIn = [&](int axis, int low) { return point[axis] > low && point[axis] <= low + 5; };
    return isIn(2, 0) && ((isIn(0, 0) && isIn(1, 0)) || (isIn(0, 5) && isIn(1, 5)));
  });
  const auto line = Centerline(Line({ 3, 3, 3 }, { 8, 8, 3 }));
  EXPECT_EQ(1, shapeton::RepairLumenTopology(cubes, line).report.droppedPieces);
  const auto bridged = shapeton::AddBridges(cubes, line);
  EXPECT_EQ(0, shapeton::RepairLumenTopology(bridged.occupancy, line).report.droppedPieces);
}

TEST(ColonWall, BridgesEnlargeTheGridAndReportWhatNoGapExplains)
{
  const auto occupancy = Occupancy(Sphere({ 0, 0, 0 }, 8), BoxOf({ { 0, 0, 0 } }, 8));
  const auto bridged = shapeton::AddBridges(occupancy, Centerline(Line({ 0, 0, 0 }, { 0, 30, 0 })));
  ASSERT_EQ(1U, bridged.warnings.size());
  EXPECT_NE(std::string::npos, bridged.warnings[0].find("to 30 mm")) << bridged.warnings[0];
  const auto mesh = shapeton::ExtractWall(bridged.occupancy);
  EXPECT_NEAR(32.0, mesh.V.col(1).maxCoeff(), 0.1);
  EXPECT_NEAR(-8.0, mesh.V.col(1).minCoeff(), 0.05);
  EXPECT_THROW(shapeton::AddBridges(occupancy, BrokenCenterline(), 0.0), shapeton::ParameterError);
  EXPECT_THROW(shapeton::AddBridges(occupancy, shapeton::CurveSet()), shapeton::InputError);
}

TEST(ColonWall, OpensBothEnds)
{
  for (const Grid & grid : { Grid(), ObliqueGrid(true) })
  {
    const auto                closed = shapeton::ExtractWall(TubeOccupancy(grid));
    shapeton::OpenEndsOptions options;
    options.radius = 10.0;
    const auto open = shapeton::OpenColonEnds(closed, Centerline(TubeAxis), options);
    EXPECT_EQ(10.0, open.rectumRadius);
    EXPECT_EQ(10.0, open.cecumRadius);
    ExpectOpenEnds(open.mesh, 0);
    // Discs at the round ends: 10 mm along a sphere with a radius of 12 mm, slightly less since paths follow edges.
    const double angle = 10.0 / TubeRadius;
    const double height = TubeRadius * std::cos(angle);
    EXPECT_NEAR(-height, CenterOfLoop(open.mesh, "rectumLoop")[2], 1.1);
    EXPECT_NEAR(TubeLength + height, CenterOfLoop(open.mesh, "cecumLoop")[2], 1.1);
    EXPECT_GT(0.5, CenterOfLoop(open.mesh, "cecumLoop").head<2>().norm());
  }
}

TEST(ColonWall, MakesTheDiscSmallerWhereItIsNone)
{
  // A disc of 20 mm around the pole includes the other end of the tube, which has a radius of 5 mm and a length of 30
  // mm.
  const Points axis = Line({ 0, 0, 0 }, { 0, 0, 20 });
  const auto   closed = shapeton::ExtractWall(Occupancy(Tube({ axis.front(), axis.back() }, 5), BoxOf(axis, 5)));
  shapeton::OpenEndsOptions options;
  options.radius = 20.0;
  const auto open = shapeton::OpenColonEnds(closed, Centerline(axis), options);
  EXPECT_EQ(20.0, open.rectumRadius);
  EXPECT_GT(20.0, open.cecumRadius);
  ExpectOpenEnds(open.mesh, 0);
  // A region that contains a torus is not a disc.
  const Depth lumen = Union(Tube({ { 0, 0, 0 }, { 0, 0, 50 } }, 6), Torus({ 0, 0, -6 }, 4, 2));
  const auto  handle = shapeton::ExtractWall(
    Occupancy(Union(lumen, Torus({ 6, 0, -4 }, 5, 1.5)), BoxOf({ { 0, 0, 0 }, { 0, 0, 50 } }, 14), {}, 1.0));
  const int  genus = shapeton::SurfaceConnectivity(handle).Components().front().genus.value();
  const auto cut = shapeton::OpenColonEnds(handle, Centerline(Line({ 0, 0, 0 }, { 0, 0, 50 })), options);
  EXPECT_LT(0, genus);
  ExpectOpenEnds(cut.mesh, genus);
}

TEST(ColonWall, MakesTheDiscLargerWhereEdgesAreLong)
{
  Grid coarse;
  coarse.spacing = { 6.0, 6.0, 6.0 };
  const auto closed = shapeton::ExtractWall(TubeOccupancy(coarse));
  const auto open = shapeton::OpenColonEnds(closed, Centerline(TubeAxis));
  EXPECT_LT(3.0, open.cecumRadius);
  EXPECT_GE(2.0 * 6.0 * std::sqrt(3.0), open.cecumRadius);
  ExpectOpenEnds(open.mesh, 0);
}

TEST(ColonWall, RefusesToOpenWhatIsNotClosed)
{
  const auto open = shapeton::OpenColonEnds(shapeton::ExtractWall(TubeOccupancy()), Centerline(TubeAxis));
  EXPECT_THROW(shapeton::OpenColonEnds(open.mesh, Centerline(TubeAxis)), shapeton::InputError);
  const auto closed = shapeton::ExtractWall(TubeOccupancy());
  EXPECT_THROW(shapeton::OpenColonEnds(closed, Centerline({ { 0, 0, 0 }, { 0, 0, 0 } })), shapeton::InputError);
}

TEST(ColonWall, PiecesCanStayApart)
{
  shapeton::SurfaceMesh       raw;
  shapeton::SurfaceMesh       repaired;
  shapeton::ColonWallSettings options;
  options.faces = 3000;
  options.ends.radius = 8.0;
  options.keepPieces = true;
  options.facts = { { "patient", "a tube" } };
  options.besideSimplification = [&](const auto & first, const auto & second) {
    raw = first;
    repaired = second;
  };
  const auto wall = shapeton::BuildColonWall(BrokenTube(), BrokenCenterline(), options);
  for (const auto & [given, mesh] : { std::pair{ &raw, &wall.raw }, std::pair{ &repaired, &wall.repaired } })
  {
    EXPECT_EQ(given->V, mesh->V);
    EXPECT_EQ(given->F, mesh->F);
    EXPECT_EQ(given->facts, options.facts);
    EXPECT_EQ(given->pointArrays.back().values, mesh->pointArrays.back().values);
    EXPECT_EQ(given->cellArrays.front().name, "bridged");
  }
  EXPECT_EQ(wall.report.rawQuality.faces, wall.raw.NumberOfFaces());
  EXPECT_EQ(wall.report.repairedQuality.genus, shapeton::InspectSurface(wall.repaired).genus);
  EXPECT_EQ(wall.report.simplifiedQuality.area, shapeton::InspectSurface(wall.simplified).area);
  EXPECT_GT(wall.report.bridgedFaces, 0);
  EXPECT_GT(wall.report.repairedFaces, wall.repaired.NumberOfFaces());
  for (const shapeton::SurfaceMesh * mesh : { &wall.raw, &wall.repaired, &wall.simplified })
  {
    const shapeton::SurfaceQuality quality = shapeton::InspectSurface(*mesh);
    EXPECT_EQ(2U, quality.components.size());
    EXPECT_EQ(4U, quality.boundaryLoopLengths.size()); // one opened end and one tube mouth per piece
    EXPECT_TRUE(quality.isManifold);
    EXPECT_EQ(0.0, shapeton::FindSurfaceArray(mesh->cellArrays, "bridged")->values.sum());
    ExpectLoopsAtBoundary(*mesh);
  }
}

TEST(ColonWall, SmallWallsKeepTheirFacesUnlessANumberIsGiven)
{
  shapeton::ColonWallSettings options;
  options.ends.radius = 8.0;
  const auto wall = shapeton::BuildColonWall(BrokenTube(), BrokenCenterline(), options);
  ASSERT_LT(wall.repaired.NumberOfFaces(), 55000);
  EXPECT_EQ(wall.repaired.F, wall.simplified.F);
  options.faces = 999;
  EXPECT_THROW(shapeton::BuildColonWall(BrokenTube(), BrokenCenterline(), options), shapeton::ParameterError);
}

TEST(ColonWall, TheChainOnABrokenTube)
{
  shapeton::ColonWallSettings options;
  options.faces = 3000;
  options.ends.radius = 8.0;
  double progress = 0.0;
  options.progress = [&progress](double share) {
    EXPECT_LE(progress, share);
    progress = share;
  };
  const auto wall = shapeton::BuildColonWall(BrokenTube(ObliqueGrid(true)), BrokenCenterline(), options);
  ExpectOpenEnds(wall.raw, 0);
  ExpectOpenEnds(wall.repaired, 0);
  ExpectOpenEnds(wall.simplified, 0);
  EXPECT_TRUE(wall.report.warnings.empty());
  EXPECT_LT(15.0, shapeton::InspectSurface(wall.raw).smallestAngle.percentile1);
  EXPECT_LT(15.0, shapeton::InspectSurface(wall.repaired).smallestAngle.percentile1);
  EXPECT_NEAR(3000, wall.simplified.NumberOfFaces(), 60);
  EXPECT_EQ(1.0, progress);
  EXPECT_LT(15.0, shapeton::InspectSurface(wall.simplified).smallestAngle.percentile1);
  for (const shapeton::SurfaceMesh * mesh : { &wall.raw, &wall.repaired, &wall.simplified })
  {
    const auto & bridged = shapeton::FindSurfaceArray(mesh->cellArrays, "bridged")->values;
    const auto & arcLength = shapeton::FindSurfaceArray(mesh->pointArrays, "arcLength")->values;
    for (Eigen::Index f = 0; f < mesh->F.rows(); ++f)
    {
      const Eigen::Vector3d center =
        (mesh->V.row(mesh->F(f, 0)) + mesh->V.row(mesh->F(f, 1)) + mesh->V.row(mesh->F(f, 2))) / 3.0;
      if (center[2] > 51.5 && center[2] < 68.5)
      {
        EXPECT_EQ(1.0, bridged(f, 0)) << center.transpose();
      }
      else if (center[2] < 48.5 || center[2] > 71.5)
      {
        EXPECT_EQ(0.0, bridged(f, 0)) << center.transpose();
      }
    }
    for (Eigen::Index v = 0; v < mesh->V.rows(); ++v)
    {
      EXPECT_NEAR(std::clamp(mesh->V(v, 2), 0.0, 120.0), arcLength(v, 0), 1e-6);
    }
  }
}

TEST(ColonWall, TheChainCutsALeakAndTheSimplifiedWallHasItsTopology)
{
  const Points                axis = UTurn(40, 21);
  const Depth                 tube = Tube(axis, 10);
  const Depth                 leak = Tube({ { 5, 0, 20 }, { 16, 0, 20 } }, 1.5);
  const Eigen::AlignedBox3d   box = BoxOf(axis, 10);
  shapeton::ColonWallSettings options;
  options.faces = 4000;
  const auto plain = shapeton::BuildColonWall(Occupancy(tube, box, ObliqueGrid(false), 2.0), Centerline(axis), options);
  const auto occupancy = Occupancy(Union(tube, leak), box, ObliqueGrid(false), 2.0);
  for (const auto topology :
       { shapeton::WallTopology::Repaired, shapeton::WallTopology::Denoised, shapeton::WallTopology::Raw })
  {
    options.topology = topology;
    const auto wall = shapeton::BuildColonWall(occupancy, Centerline(axis), options);
    const int  genus = topology == shapeton::WallTopology::Raw ? 1 : 0;
    EXPECT_EQ(topology == shapeton::WallTopology::Repaired ? 0 : 1, wall.report.simplifiedGenusBefore);
    EXPECT_EQ(genus, wall.report.simplifiedGenus);
    EXPECT_EQ(1, wall.report.rawGenus); // for any topology, as are the next ones
    EXPECT_EQ(0, wall.report.repairedGenus);
    EXPECT_GT(0.02, wall.report.topology.cutVolume);
    ExpectOpenEnds(wall.raw, 1);
    ExpectOpenEnds(wall.repaired, 0);
    EXPECT_LT(15.0, shapeton::InspectSurface(wall.simplified).smallestAngle.percentile1);
    ExpectOpenEnds(wall.simplified, genus);
    EXPECT_NEAR(1.0, wall.report.simplifiedQuality.area / plain.report.simplifiedQuality.area, 0.02);
    EXPECT_EQ(wall.simplified.NumberOfVertices(), wall.simplified.pointArrays.back().values.rows()); // arcLength
  }
}

TEST(ColonWall, ArcLengthIsThatOfTheOwnLoop)
{
  const Points                axis = TwoLegs();
  shapeton::ColonWallSettings options;
  options.faces = 4000;
  options.ends.radius = 5.0;
  const auto   wall = shapeton::BuildColonWall(OccupancyOfTwoLegs(axis), Centerline(axis), options);
  const auto & arcLength = shapeton::FindSurfaceArray(wall.repaired.pointArrays, "arcLength")->values;
  for (Eigen::Index v = 0; v < wall.repaired.V.rows(); ++v)
  {
    const Eigen::Vector3d p = wall.repaired.V.row(v);
    if (p[2] > 0.0 && p[2] < 30.0 && std::abs(p[0] - 14.5) > 0.2)
    {
      EXPECT_NEAR(p[0] < 14.5 ? p[2] : 119.0 - p[2], arcLength(v, 0), 0.5) << p.transpose();
    }
  }
}

TEST(ColonWall, VoxelsAreLabeledByTheirOwnLoop)
{
  const Points axis = TwoLegs();
  const auto   mask = MaskOf(OccupancyOfTwoLegs(axis), 1);
  const auto   labels = shapeton::LabelLumenAlong(
    mask, Centerline(axis), [](double arcLength) { return static_cast<unsigned short>(arcLength < 59.5 ? 1 : 2); });
  std::size_t counted = 0;
  basetest::ForVoxels(labels, [&](const auto & index, const auto & p) {
    if (mask->GetPixel(index) == 0)
    {
      EXPECT_EQ(labels->GetPixel(index), 0);
    }
    else if (p[2] > 0.0 && p[2] < 30.0 && std::abs(p[0] - 14.5) > 1.0)
    {
      EXPECT_EQ(labels->GetPixel(index), p[0] < 14.5 ? 1 : 2) << p;
      ++counted;
    }
  });
  EXPECT_GT(counted, 500u);
}

TEST(ColonWall, TheChainOnAMask)
{
  shapeton::ColonWallSettings options;
  options.faces = 3000;
  options.ends.radius = 20.0; // without the poles, where the stairs of a mask are wide
  const auto wall =
    shapeton::BuildColonWallFromMask(MaskOf(TubeOccupancy(ObliqueGrid(true)), 2), Centerline(TubeAxis), options);
  const Depth tube = Tube({ TubeAxis.front(), TubeAxis.back() }, TubeRadius);
  ExpectOpenEnds(wall.raw, 0);
  ExpectOpenEnds(wall.repaired, 0);
  ExpectOpenEnds(wall.simplified, 0);
  EXPECT_LT(0.3, GreatestError(wall.raw, tube)); // stairs of the mask
  EXPECT_GT(0.3, GreatestError(wall.repaired, tube));
  double sum = 0.0;
  for (Eigen::Index v = 0; v < wall.repaired.V.rows(); ++v)
  {
    sum += tube(wall.repaired.V.row(v));
  }
  EXPECT_NEAR(0.0, sum / static_cast<double>(wall.repaired.V.rows()), 0.06); // neither shrinking nor growth
}

TEST(ColonWall, SameBytesForAnyNumberOfThreads)
{
  shapeton::ColonWallSettings options;
  options.faces = 2000;
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const auto                       wall = shapeton::BuildColonWall(BrokenTube(), BrokenCenterline(), options);
      std::vector<std::vector<double>> values;
      for (const shapeton::SurfaceMesh * mesh : { &wall.raw, &wall.repaired, &wall.simplified })
      {
        values.emplace_back(mesh->V.data(), mesh->V.data() + mesh->V.size());
        values.emplace_back(mesh->F.data(), mesh->F.data() + mesh->F.size());
        for (const auto * arrays : { &mesh->pointArrays, &mesh->cellArrays })
        {
          const auto & first = arrays->front().values;
          values.emplace_back(first.data(), first.data() + first.size());
        }
      }
      return values;
    },
    { 2, 3 });
}
