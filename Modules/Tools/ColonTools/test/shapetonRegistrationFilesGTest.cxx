#include "shapetonColonPointMapper.h"
#include "shapetonJson.h"
#include "shapetonRegisteredTestPair.h"
#include "shapetonRegistrationFiles.h"
#include "shapetonRegistrationFolder.h"
#include "shapetonFileBytes.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

namespace
{
namespace fs = std::filesystem;
using namespace tubecolons;

std::string
FreshFolder(const std::string & name)
{
  const std::string folder = ::testing::TempDir() + "RegistrationFiles/" + name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

template <typename TAction>
std::string
FaultOf(const TAction & action)
{
  return basetest::ErrorOf([&] { action(); });
}
} // namespace

TEST(RegistrationResults, TheMapOnTheSurfaceIsThatOfTheRegistration)
{
  const Pair &                  pair = TestPair();
  const shapeton::SurfaceMesh & map = pair.results.supineToProne;
  EXPECT_EQ(map.V, pair.supine.position.flat->Surface().V);
  EXPECT_EQ(map.F, pair.supine.position.flat->Surface().F);
  const auto & uv = shapeton::FindSurfaceArray(map.pointArrays, "uv")->values;
  const auto & mapped = shapeton::FindSurfaceArray(map.pointArrays, "mapped")->values;
  const auto & mappedUv = shapeton::FindSurfaceArray(map.pointArrays, "mappedUv")->values;
  const auto & displacement = shapeton::FindSurfaceArray(map.pointArrays, "displacement")->values;
  for (Eigen::Index i = 0; i < map.V.rows(); i += 97)
  {
    EXPECT_LT((shapeton::MapUv(pair.registration, uv.row(i).transpose()) - mappedUv.row(i).transpose()).norm(), 1e-9);
    EXPECT_LT((map.V.row(i) + displacement.row(i) - mapped.row(i)).norm(), 1e-9);
    // On the prone wall: at most 5 mm (the height of a fold) inside the tube.
    EXPECT_LT(mapped.row(i).head<2>().norm(), radius + 1e-6);
    EXPECT_GT(mapped.row(i).head<2>().norm(), radius - 5.1);
  }
  const auto & confidence = shapeton::FindSurfaceArray(map.pointArrays, "confidence")->values;
  EXPECT_GE(confidence.minCoeff(), 0.0);
  EXPECT_LE(confidence.maxCoeff(), 1.0);
  EXPECT_EQ(shapeton::FindSurfaceArray(map.pointArrays, "excluded")->values.sum(), 0.0);
}

TEST(RegistrationResults, BothMapsAreInverse)
{
  const Pair &                     pair = TestPair();
  const shapeton::ColonPointMapper mapper(pair.registration);
  const auto & back = shapeton::FindSurfaceArray(pair.results.proneToSupine.pointArrays, "mappedUv")->values;
  const auto & uv = shapeton::FindSurfaceArray(pair.prone.position.flat->Surface().pointArrays, "uv")->values;
  for (Eigen::Index i = 0; i < uv.rows(); i += 97)
  {
    const Eigen::Vector2d forth = mapper.ForwardUv(back.row(i).transpose()).uv;
    EXPECT_NEAR(forth.x(), uv(i, 0), 1e-6);
    EXPECT_NEAR(std::remainder(forth.y() - uv(i, 1), Form().circumference), 0.0, 1e-6);
  }
}

TEST(RegistrationResults, PointsInSpaceGoThere)
{
  const Pair &                     pair = TestPair();
  const shapeton::ColonPointMapper mapper(pair.registration);
  const shapeton::PointPair        known = KnownPoints(movement)[240]; // on a taenia
  const shapeton::MappedPoint      at = mapper.Forward(known.source);
  EXPECT_LT((at.point - known.target).norm(), 3.0);
  EXPECT_LT((mapper.Inverse(at.point).point - known.source).norm(), 0.5);
  EXPECT_NEAR(mapper.Forward(Eigen::Vector3d(radius + 7.0, 0.0, 300.0)).distance, 7.0, 0.1);
  EXPECT_FALSE(at.isExcluded);
}

TEST(RegistrationResults, CountsOfSegmentsAddUp)
{
  const Pair & pair = TestPair();
  int          supine = 0, prone = 0, pairs = 0, correct = 0, wrong = 0, unmatched = 0;
  for (const shapeton::SegmentMatches & row : pair.results.segments)
  {
    supine += row.supineFolds;
    prone += row.proneFolds;
    pairs += row.followed + row.contradicted;
    correct += row.correct;
    wrong += row.wrong;
    unmatched += row.unmatched;
    EXPECT_EQ(row.supineAlone + row.followed + row.contradicted, row.supineFolds);
    EXPECT_GT(row.confidence, 0.5) << row.segment;
  }
  EXPECT_EQ(pair.results.segments.size(), 5U);
  EXPECT_EQ(supine, static_cast<int>(pair.supine.position.folds.size()));
  EXPECT_EQ(prone, static_cast<int>(pair.prone.position.folds.size()));
  EXPECT_EQ(pairs, static_cast<int>(pair.results.matches.size()));
  EXPECT_EQ(pair.results.document["matches"]["correct"], correct);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(correct, 0.8 * supine); // the others have no known point nearby, or were not matched
}

TEST(RegistrationResults, VerdictsFollowTheTruth)
{
  const Pair & pair = TestPair();
  // Shifts the prone wall by one gap between folds: hardly any pair can be correct by chance.
  std::vector<shapeton::PointPair> shifted = KnownPoints(movement);
  for (shapeton::PointPair & known : shifted)
  {
    known.target.z() += 20.0;
  }
  const auto wrong = shapeton::MakeRegistrationResults(pair.supine, pair.prone, pair.registration, shifted);
  EXPECT_GT(wrong.document["matches"]["wrong"], 0.6 * wrong.matches.size());
  // A removed pair is reported as missing for both folds.
  shapeton::SupineProneRegistration fewer = pair.registration;
  fewer.matches.erase(fewer.matches.begin() + 20);
  const auto missed = shapeton::MakeRegistrationResults(pair.supine, pair.prone, fewer, pair.results.points);
  EXPECT_EQ(missed.document["matches"]["unmatched"], 1);
  EXPECT_EQ(missed.document["matches"]["correct"], pair.results.document["matches"]["correct"].get<int>() - 1);
  EXPECT_EQ(missed.matches[20].verdict, shapeton::FoldVerdict::Correct);
  // Without points no verdicts are possible.
  const auto unknown = shapeton::MakeRegistrationResults(pair.supine, pair.prone, pair.registration);
  EXPECT_EQ(unknown.matches[0].verdict, shapeton::FoldVerdict::Unknown);
  EXPECT_FALSE(unknown.document["matches"].contains("correct"));
}

TEST(RegistrationResults, TablesAreReadBack)
{
  const shapeton::RegistrationResults & results = TestPair().results;
  const std::string                     folder = FreshFolder("results");
  shapeton::TableOfMatches(results).Write(folder + "/matches.csv");
  shapeton::TableOfErrors(results).Write(folder + "/errors.csv");
  shapeton::WriteJson(results.document, folder + "/registration.json");
  shapeton::WriteSurface(results.supineToProne, folder + "/map-supine-to-prone.vtp");
  shapeton::WriteSurface(results.proneToSupine, folder + "/map-prone-to-supine.vtp");
  const shapeton::RegistrationResults read = shapeton::ReadRegistrationResults(folder);
  EXPECT_EQ(shapeton::TableOfMatches(read).GetRows(), shapeton::TableOfMatches(results).GetRows());
  EXPECT_EQ(shapeton::TableOfErrors(read).GetRows(), shapeton::TableOfErrors(results).GetRows());
  EXPECT_EQ(read.document, results.document);
  ASSERT_EQ(read.segments.size(), results.segments.size());
  EXPECT_EQ(read.segments[1].followed, results.segments[1].followed);
  EXPECT_NEAR(read.segments[1].confidence, results.segments[1].confidence, 1e-5);
  const auto & mapped = shapeton::FindSurfaceArray(read.supineToProne.pointArrays, "mapped")->values;
  EXPECT_EQ(mapped, shapeton::FindSurfaceArray(results.supineToProne.pointArrays, "mapped")->values);
  std::filesystem::remove(folder + "/matches.csv");
  EXPECT_NE(FaultOf([&] { shapeton::ReadRegistrationResults(folder); }).find("matches.csv"), std::string::npos);
}

TEST(RegistrationResults, TheValveOfBothPositionsIsReadUnlessTheRegistrationIsDoubtful)
{
  const std::string folder = FreshFolder("valve");
  shapeton::Json    document = TestPair().results.document;
  ASSERT_TRUE(document.contains("ileocecalValve"));
  shapeton::IleocecalValve valve;
  valve.arcLength = 1500.0;
  document["ileocecalValve"]["prone"] = shapeton::ValveToJson({ valve, "", { valve } });
  document["confidence"] = { { "whole", 0.9 }, { "flagged", false } };
  shapeton::WriteJson(document, folder + "/registration.json");
  const auto prone = shapeton::ValveOfRegistration(folder, 1);
  ASSERT_TRUE(prone && prone->valve);
  EXPECT_EQ(prone->valve->arcLength, 1500.0);
  EXPECT_FALSE(shapeton::ValveOfRegistration(folder, 0)->valve); // a cylinder without a valve
  document["confidence"]["flagged"] = true;
  shapeton::WriteJson(document, folder + "/registration.json");
  EXPECT_FALSE(shapeton::ValveOfRegistration(folder, 1));
}

TEST(RegistrationResults, TheNumbersOfTaeniaeAreReadBack)
{
  const std::string path = FreshFolder("numbers") + "/registration.json";
  shapeton::Json    document = TestPair().results.document;
  shapeton::WriteJson(document, path);
  const auto numbers = shapeton::TaeniaNumbersOfRegistration(path);
  ASSERT_TRUE(numbers);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ((*numbers)[i], TestPair().registration.taeniae.target[i] + 1);
  }
  document["taeniae"]["proneOfSupine"] = nullptr;
  shapeton::WriteJson(document, path);
  EXPECT_FALSE(shapeton::TaeniaNumbersOfRegistration(path));
}

TEST(RegistrationResults, AValveThatOnePositionShowsIsMappedToTheOther)
{
  const Pair &                 pair = TestPair();
  const shapeton::PointPair    known = KnownPoints(movement)[240];
  shapeton::ColonPositionFiles supine = pair.supine;
  shapeton::IleocecalValve     valve;
  valve.position = known.source;
  valve.confidence = 0.9;
  shapeton::SetIleocecalValve({ valve, "", { valve } }, supine.position.centerline);
  const auto results = shapeton::MakeRegistrationResults(supine, pair.prone, pair.registration);
  const auto there = shapeton::ValveFromJson(results.document["ileocecalValve"]["prone"]);
  ASSERT_TRUE(there.valve);
  EXPECT_LT((there.valve->position - known.target).norm(), 3.0);
  EXPECT_GT(there.valve->confidence, 0.5);
  EXPECT_NEAR(there.valve->arcLength, known.target.z() - pair.prone.position.centerline.V.col(2).minCoeff(), 30.0);
  EXPECT_EQ(shapeton::ValveFromJson(results.document["ileocecalValve"]["supine"]).valve->position, known.source);
}

TEST(RegistrationResults, ErrorsOfTheMapAndOfTheFrame)
{
  const shapeton::Json & document = TestPair().results.document;
  EXPECT_LT(document["errors"]["mean"].get<double>(), 2.0);
  EXPECT_EQ(document["errors"]["counted"], TestPair().results.points.size());
  EXPECT_EQ(document["errors"]["shareWithin10"], 1.0);
  EXPECT_GT(document["errorsOfFrame"]["mean"].get<double>(), 0.0);
  EXPECT_EQ(document["map"]["flips"], 0);
  EXPECT_EQ(document["flexures"].size(), 4U);
}

TEST(RegistrationFiles, PointPairsAreReadOrRefusedByLine)
{
  const std::string path = FreshFolder("points") + "/points.csv";
  shapeton::WriteFileBytes(path, "sx,sy,sz,px,py,pz\n1,2,3,4,5,6\n-1,0,0.5,0,0,0\n");
  const auto pairs = shapeton::ReadPointPairs(path);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].target, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(pairs[1].source, Eigen::Vector3d(-1, 0, 0.5));
  const auto fault = [&](const std::string & text) {
    shapeton::WriteFileBytes(path, text);
    return FaultOf([&] { shapeton::ReadPointPairs(path); });
  };
  EXPECT_NE(fault("sx,sy,sz,px,py,pz\n1,2,3,4,five,6\n").find("line 2: py is \"five\""), std::string::npos);
  EXPECT_NE(fault("x,y,z\n1,2,3\n").find("the column \"sx\" is missing"), std::string::npos);
  EXPECT_NE(fault("sx,sy,sz,px,py,pz\n").find("contains no points"), std::string::npos);
}
