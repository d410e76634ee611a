#include "shapetonCoarseHeat.h"
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonJson.h"
#include "shapetonLiveSession.h"
#include "shapetonMappedImage.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticlePreset.h"
#include "shapetonRandomCommands.h"
#include "shapetonSessionTestVolume.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <random>

namespace
{
using shapeton::Json;
using shapeton::LiveSession;
using ImageType = itk::Image<float, 3>;

/** A session with its folder. */
struct Fixture
{
  explicit Fixture(int scale = 1) : input(scale), session(input.Volume(), input.Settings()) {}

  Json
  Do(const std::string & command)
  {
    return session.Do(Json::parse(command));
  }

  void
  Finish()
  {
    while (session.Work())
    {}
  }

  basetest::SessionInput input;
  LiveSession            session;
};

/** The message of the error that a command causes; empty for none. */
std::string
ErrorOf(Fixture & fixture, const std::string & command)
{
  try
  {
    fixture.Do(command);
  }
  catch (const shapeton::Exception & error)
  {
    return error.what();
  }
  return "";
}

/** The visits after a run of the filter with the options of the session. */
ImageType::Pointer
VisitsOfFilter(const Fixture &                            fixture,
               std::uint64_t                              steps,
               const shapeton::ParticleDiffusionOptions & walk,
               const std::string &                        mask = "")
{
  const auto volume = fixture.input.Volume();
  auto       filter = shapeton::ParticleDiffusionImageFilter<ImageType>::New();
  auto       options = walk;
  options.timeSteps = steps;
  filter->SetInput(volume.image);
  filter->SetOptions(options);
  if (!mask.empty())
  {
    filter->SetMaskImage(shapeton::MaskForImage(shapeton::ReadVolume(mask), mask, volume.image));
  }
  filter->Update();
  return shapeton::MapVoxels<float>(filter->GetOutput(), [](auto number) { return static_cast<float>(number); });
}

void
ExpectSameVoxels(const ImageType * a, const ImageType * b)
{
  ASSERT_EQ(a->GetBufferedRegion().GetSize(), b->GetBufferedRegion().GetSize());
  EXPECT_EQ(std::memcmp(
              a->GetBufferPointer(), b->GetBufferPointer(), a->GetBufferedRegion().GetNumberOfPixels() * sizeof(float)),
            0);
}

/** The header and the arrays of a frame. */
struct Frame
{
  explicit Frame(const std::string & bytes)
  {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof(length));
    header = Json::parse(bytes.substr(sizeof(length), length));
    arrays = bytes.substr(sizeof(length) + length);
  }

  Json        header;
  std::string arrays;
};

TEST(LiveSession, SavesTheVisitsOfTheFilterAfterAnyNumberOfSteps)
{
  Fixture fixture;
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["step"], 60);
  fixture.Do(R"({"do": "step", "steps": 7})");
  fixture.Finish();
  const auto saved = fixture.Do(R"({"do": "save", "name": "a"})");
  EXPECT_EQ(saved["files"], (Json{ "a-density.nrrd", "a.sh" }));
  const auto density = shapeton::ReadVolume(fixture.input.GetFolder() / "a-density.nrrd");
  ExpectSameVoxels(density.image, VisitsOfFilter(fixture, 67, fixture.input.Settings().walk));
}

TEST(LiveSession, AnInterruptedWalkLosesNoStep)
{
  Fixture fixture;
  fixture.Do(R"({"do": "set", "shapetons": 100000, "distance": 0.2})");
  fixture.session.Work(); // starts
  int        polls = 0;
  const auto interrupt = [&] {
    ++polls;
    fixture.session.Interrupt();
  };
  while (fixture.session.Work(interrupt))
  {}
  EXPECT_GT(polls, 0);
  fixture.Do(R"({"do": "save", "name": "i"})");
  auto walk = fixture.input.Settings().walk;
  walk.shapetons = 100000;
  walk.distance = 0.2;
  ExpectSameVoxels(shapeton::ReadVolume(fixture.input.GetFolder() / "i-density.nrrd").image,
                   VisitsOfFilter(fixture, 60, walk));
}

TEST(LiveSession, ChangesStartTheWalkAgain)
{
  Fixture fixture;
  fixture.Finish();
  fixture.Do(R"({"do": "set", "p": 9, "distance": 0.08, "shapetons": 500, "seed": 4, "directionSampling": "uniform",
                 "pathRule": "traversal", "placement": "initialHeat"})");
  EXPECT_EQ(fixture.session.GetState()["step"], 0);
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "b"})");
  auto walk = fixture.input.Settings().walk;
  walk.p = 9.0;
  walk.distance = 0.08;
  walk.shapetons = 500;
  walk.seed = 4;
  walk.directionSampling = shapeton::DirectionSampling::Uniform;
  walk.pathRule = shapeton::PathRule::Traversal;
  walk.placement = shapeton::ParticlePlacement::InitialHeat;
  const auto density = shapeton::ReadVolume(fixture.input.GetFolder() / "b-density.nrrd");
  ExpectSameVoxels(density.image, VisitsOfFilter(fixture, 60, walk));
}

TEST(LiveSession, StartRegionsAreBallsObjectsAndFiles)
{
  Fixture    fixture;
  const auto middle = fixture.input.PointOf({ { 7, 9, 10 } });
  Json       start = { { "do", "start" }, { "region", "balls" } };
  start["balls"] = { { middle[0], middle[1], middle[2], 2.1 } };
  fixture.session.Do(start);
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "ball"})");
  const auto mask = shapeton::ReadVolume(fixture.input.GetFolder() / "start-1.nrrd").image;
  EXPECT_EQ(mask->GetPixel({ { 7, 9, 10 } }), 1.0F);
  EXPECT_EQ(mask->GetPixel({ { 9, 9, 10 } }), 1.0F); // 2 mm away
  EXPECT_EQ(mask->GetPixel({ { 7, 9, 12 } }), 0.0F); // 3 mm away
  const auto density = shapeton::ReadVolume(fixture.input.GetFolder() / "ball-density.nrrd");
  const auto visits =
    VisitsOfFilter(fixture, 60, fixture.input.Settings().walk, fixture.input.GetFolder() / "start-1.nrrd");
  ExpectSameVoxels(density.image, visits);

  fixture.Do(R"({"do": "start", "region": "file", "name": "start-1.nrrd", "label": 1})");
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "file"})");
  ExpectSameVoxels(shapeton::ReadVolume(fixture.input.GetFolder() / "file-density.nrrd").image, visits);

  // An object of the heat: the box, whose voxels are warmer than its surroundings.
  fixture.Do(R"({"do": "set", "p": 20})");
  fixture.Do(R"({"do": "heat", "timeSteps": 2000})");
  fixture.Finish();
  const auto inBox = fixture.input.PointOf({ { 18, 10, 11 } });
  start = { { "do", "start" }, { "region", "object" }, { "lower", 0.2 }, { "upper", 1.0 } };
  start["point"] = { inBox[0], inBox[1], inBox[2] };
  fixture.session.Do(start);
  fixture.Do(R"({"do": "density"})");
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "box"})");
  const auto box = shapeton::ReadVolume(fixture.input.GetFolder() / "start-3.nrrd").image;
  EXPECT_EQ(box->GetPixel({ { 18, 10, 11 } }), 1.0F);
  EXPECT_EQ(box->GetPixel({ { 7, 9, 10 } }), 0.0F);
  EXPECT_EQ(box->GetPixel({ { 0, 0, 0 } }), 0.0F);
  EXPECT_NE(ErrorOf(fixture, R"({"do": "start", "region": "balls", "balls": [[900, 0, 0, 1]]})"), "");
  EXPECT_NE(ErrorOf(fixture, R"({"do": "start", "region": "file", "name": "../start-1.nrrd"})"), "");
}

TEST(LiveSession, HeatIsCoarseFirstAndThenThatOfTheFilter)
{
  Fixture fixture;
  fixture.Do(R"({"do": "set", "p": 20, "intensityWindow": [0, 110]})");
  fixture.Do(R"({"do": "heat", "timeSteps": 5000})");
  EXPECT_TRUE(fixture.session.Work());
  EXPECT_EQ(fixture.session.GetState()["quality"], "coarse");
  EXPECT_NE(ErrorOf(fixture, R"({"do": "save", "name": "heat"})"), "");
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["quality"], "exact");
  fixture.Do(R"({"do": "save", "name": "c", "labels": true})");
  auto filter = shapeton::CumulativeHeatDiffusionImageFilter<ImageType>::New();
  filter->SetInput(fixture.input.Volume().image);
  filter->SetP(20.0);
  filter->SetIntensityWindow(std::array<double, 2>{ { 0.0, 110.0 } });
  filter->SetTimeSteps(5000);
  filter->Update();
  ExpectSameVoxels(shapeton::ReadVolume(fixture.input.GetFolder() / "c-heat.nrrd").image, filter->GetOutput());
  // The walk continues where it stopped.
  fixture.Do(R"({"do": "density"})");
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "d"})");
  auto walk = fixture.input.Settings().walk;
  walk.p = 20.0;
  walk.intensityWindow = { { 0.0, 110.0 } };
  ExpectSameVoxels(shapeton::ReadVolume(fixture.input.GetFolder() / "d-density.nrrd").image,
                   VisitsOfFilter(fixture, 60, walk));
}

TEST(LiveSession, CoarseHeatOfAClosedObjectIsItsHeat)
{
  // In a closed object, heat converges to the mean of the initial heat, which the averages keep.
  auto image = basetest::NewImage<ImageType>({ { 32, 32, 32 } });
  basetest::ForVoxels(image, [&](const itk::Index<3> & i, const itk::Point<double, 3> &) {
    const auto isInside = [&](int axis) { return i[axis] >= 8 && i[axis] < 24; };
    image->SetPixel(i, isInside(0) && isInside(1) && isInside(2) ? 1.0F : 0.0F);
  });
  shapeton::CumulativeHeatDiffusionSettings settings;
  settings.timeSteps = 100000;
  const shapeton::VolumeView volume(image.GetPointer());
  std::vector<float>         heat(volume.NumberOfVoxels());
  shapeton::DiffuseCumulativeHeat(volume, settings, heat.data());
  const auto   coarse = shapeton::CoarseHeat(volume, settings).After(settings.timeSteps);
  const double exact = heat[(16 * 32 + 16) * 32 + 16];
  const auto   middle = 16 / coarse.factor;
  EXPECT_GT(coarse.factor, 1U);
  EXPECT_NEAR(coarse.values[(middle * coarse.size[1] + middle) * coarse.size[0] + middle], exact, 0.01 * exact);
}

TEST(LiveSession, FramesHoldWhatTheViewerLacks)
{
  Fixture                 fixture;
  shapeton::SessionViewer viewer;
  fixture.Finish();
  ASSERT_TRUE(fixture.session.IsNewFor(viewer));
  const Frame first(fixture.session.Update(viewer));
  const auto  voxels = std::size_t{ 24 } * 20 * 22;
  const auto  sliceVoxels = std::size_t{ 20 } * 22 + 24 * 22 + 24 * 20;
  EXPECT_EQ(first.header["slices"].size(), 3U);
  EXPECT_EQ(first.header["bricks"].size(), 1U);
  EXPECT_EQ(first.arrays.size(), 3 * sliceVoxels + 2 * voxels + 2 * 4 * 4097);
  EXPECT_FALSE(fixture.session.IsNewFor(viewer));
  // The bins of the brick are those of the visits.
  fixture.Do(R"({"do": "save", "name": "e"})");
  const auto    visits = shapeton::ReadVolume(fixture.input.GetFolder() / "e-density.nrrd").image;
  const float * begin = visits->GetBufferPointer();
  const float   greatest = *std::max_element(begin, begin + voxels);
  std::size_t   wrong = 0;
  for (std::size_t i = 0; i < voxels; ++i)
  {
    std::uint16_t bin = 0;
    std::memcpy(&bin, first.arrays.data() + 3 * sliceVoxels + 2 * i, sizeof(bin));
    wrong += bin != shapeton::HeatHistogram::BinOf(begin[i] / greatest);
  }
  EXPECT_LE(wrong, voxels / 1000); // rounding at the edge of a bin

  viewer.place = { { 3, 4, 5 } };
  viewer.isPlaceNew = true;
  Frame second(fixture.session.Update(viewer));
  EXPECT_EQ(second.arrays.size(), 3 * sliceVoxels);
  EXPECT_FALSE(second.header.contains("bricks"));
  EXPECT_EQ(second.header["slices"][0]["index"], 3);
}

TEST(LiveSession, DrawsJpeg)
{
  Fixture fixture;
  fixture.Finish();
  const std::string request = R"({"azimuth": 30, "elevation": 20, "zoom": 1, "width": 200, "height": 150, "quality": 80,
    "lines": [{"lower": 0.1, "upper": 1, "color": "#ff0000", "opacity": 1}]})";
  const Frame       frame(fixture.session.Draw(Json::parse(request)));
  EXPECT_EQ(frame.header["bytes"], frame.arrays.size());
  EXPECT_EQ(frame.arrays.substr(0, 3), "\xff\xd8\xff");
  Json       part = Json::parse(request);
  const auto pictureOf = [&](const Json & first, const Json & last) {
    part["first"] = first;
    part["last"] = last;
    return Frame(fixture.session.Draw(part)).arrays;
  };
  EXPECT_EQ(pictureOf({ 0, 0, 0 }, { 23, 19, 21 }), frame.arrays); // all voxels
  const auto left = pictureOf({ 0, 0, 0 }, { 12, 19, 21 });
  EXPECT_NE(left, frame.arrays);
  EXPECT_NE(left, pictureOf({ 13, 0, 0 }, { 23, 19, 21 }));
  EXPECT_EQ(pictureOf({ 0, 0, 14 }, { 23, 19, 6 }), pictureOf({ 9, 0, 0 }, { 3, 19, 21 })); // nothing is visible
  Json wrong = Json::parse(request);
  wrong["width"] = 100000;
  EXPECT_THROW(fixture.session.Draw(wrong), shapeton::ParameterError);
}

TEST(LiveSession, RejectsWrongCommandsAndKeepsItsState)
{
  Fixture fixture;
  fixture.Finish();
  const auto before = fixture.session.GetState();
  for (const std::string command : { R"([])",
                                     R"({})",
                                     R"({"do": 7})",
                                     R"({"do": "dance"})",
                                     R"({"do": "set"})",
                                     R"({"do": "set", "p": "7"})",
                                     R"({"do": "set", "p": -1})",
                                     R"({"do": "set", "p": 5, "distance": 0})",
                                     R"({"do": "set", "shapetons": 2.5})",
                                     R"({"do": "set", "pathRule": "straight"})",
                                     R"({"do": "set", "intensityWindow": [3, 1]})",
                                     R"({"do": "set", "timeSteps": 5})",
                                     R"({"do": "pause", "now": true})",
                                     R"({"do": "step", "steps": -4})",
                                     R"({"do": "step"})",
                                     R"({"do": "speed", "stepsPerSecond": "fast"})",
                                     R"({"do": "heat", "timeSteps": 1e99})",
                                     R"({"do": "start", "region": "moon"})",
                                     R"({"do": "start", "region": "balls", "balls": []})",
                                     R"({"do": "start", "region": "balls", "balls": [[0, 0, 0, -1]]})",
                                     R"({"do": "start", "region": "file", "name": "/etc/passwd"})",
                                     R"({"do": "save", "name": "../a"})",
                                     R"({"do": "save", "name": ""})",
                                     R"({"do": "save", "name": "-rf"})",
                                     R"({"do": "save", "name": "a", "lines": [{"lower": 1}]})" })
  {
    EXPECT_NE(ErrorOf(fixture, command), "") << command;
    EXPECT_EQ(fixture.session.GetState(), before) << command;
  }
}

TEST(LiveSession, AnInterruptedHeatIsComputedAgain)
{
  Fixture fixture;
  fixture.Do(R"({"do": "heat", "timeSteps": 1000000})");
  fixture.session.Work();
  int polls = 0;
  fixture.session.Work([&] {
    if (++polls == 3)
    {
      fixture.session.Interrupt();
    }
  });
  EXPECT_EQ(fixture.session.GetState()["quality"], "coarse");
  fixture.Do(R"({"do": "heat", "timeSteps": 3000})");
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["quality"], "exact");
  EXPECT_EQ(fixture.session.GetState()["heatSteps"], 3000);
}

TEST(LiveSession, ReportsAWalkThatCannotStart)
{
  Fixture fixture;
  fixture.Do(R"({"do": "set", "placement": "initialHeat", "p": 0})");
  fixture.Finish();
  EXPECT_NE(fixture.session.GetState()["error"], "");
  fixture.Do(R"({"do": "set", "p": 7})");
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["error"], "");
  EXPECT_EQ(fixture.session.GetState()["step"], 60);
}

/** Runs the script of a session with the tools; returns the exit status, or -1 if the tools have not been built. */
int
RunScript(const std::string & script, const std::string & results)
{
  if (!std::filesystem::exists(std::string(SHAPETON_TOOLS) + "/ShapetonDiffusion") ||
      !std::filesystem::exists(std::string(SHAPETON_TOOLS) + "/CumulativeHeatDiffusion") ||
      !std::filesystem::exists(std::string(SHAPETON_TOOLS) + "/HeatObjects") ||
      !std::filesystem::exists(std::string(SHAPETON_TOOLS) + "/HeatTransferFunction"))
  {
    return -1;
  }
  std::filesystem::create_directory(results);
  return std::system(("PATH=" SHAPETON_TOOLS ":$PATH sh " + script + " " + results + " > /dev/null").c_str());
}

void
ExpectSameFiles(const std::string & a, const std::string & b, const std::vector<std::string> & names)
{
  for (const std::string & name : names)
  {
    const std::string first = shapeton::ReadFileBytes(a + name);
    const std::string second = shapeton::ReadFileBytes(b + name);
    const auto        end = first.begin() + static_cast<std::ptrdiff_t>(std::min(first.size(), second.size()));
    const auto        at = std::mismatch(first.begin(), end, second.begin()).first - first.begin();
    const auto        from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, at - 40));
    EXPECT_TRUE(first == second) << name << ":\n" << first.substr(from, 80) << "\n" << second.substr(from, 80);
  }
}

TEST(LiveSession, TheToolsRepeatItsFilesByteByByte)
{
  Fixture           fixture;
  const std::string lines =
    R"("lines": [{"lower": 0.1, "upper": 0.3, "color": "#3366cc", "opacity": 0.4}, {"lower": 0.3, "upper": 1, "color": "#ff0000", "opacity": 1}])";
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "first", "labels": true, )" + lines + "}");
  fixture.Do(
    R"({"do": "set", "p": 0.1, "smoothing": 0.7, "distance": 0.0333333333333, "intensityWindow": [-20, 90.5]})");
  const auto middle = fixture.input.PointOf({ { 7, 9, 10 } });
  Json       start = { { "do", "start" }, { "region", "balls" } };
  start["balls"] = { { middle[0], middle[1], middle[2], 3.0 } };
  fixture.session.Do(start);
  fixture.Do(R"({"do": "step", "steps": 41})");
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "second", "labels": true})");
  fixture.Do(R"({"do": "heat", "timeSteps": 1234})");
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "third", "labels": true, )" + lines + "}");
  const std::string results = fixture.input.GetFolder() / "results";
  const int         status = RunScript(fixture.input.GetFolder() / "third.sh", results);
  if (status < 0)
  {
    GTEST_SKIP() << "the tools have not been built";
  }
  EXPECT_EQ(status, 0);
  ExpectSameFiles(fixture.input.GetFolder() / "",
                  results + "/",
                  { "first-density.nrrd",
                    "first-labels.nrrd",
                    "first.json",
                    "first.vp",
                    "second-density.nrrd",
                    "second-labels.nrrd",
                    "third-heat.nrrd",
                    "third-labels.nrrd",
                    "third.json",
                    "third.vp" });
}

TEST(LiveSession, TheToolsRepeatItsObjectsByteByByte)
{
  Fixture fixture(3);
  fixture.Finish();
  EXPECT_NE(ErrorOf(fixture, R"({"do": "save", "name": "a", "objects": true})").find("find them first"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(fixture.input.GetFolder() / "a.sh"));
  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  EXPECT_NE(ErrorOf(fixture, R"({"do": "save", "name": "a", "selected": true})").find("no object is selected"),
            std::string::npos);
  fixture.Do(R"({"do": "select", "object": 2})");
  const Json alone = fixture.Do(R"({"do": "save", "name": "one", "selected": true})");
  EXPECT_EQ(alone["files"], (Json{ "one-heat.nrrd", "one-object.nrrd", "one-object.csv", "one.sh" }));
  const Json saved = fixture.Do(R"({"do": "save", "name": "a", "labels": true, "objects": true})");
  EXPECT_EQ(saved["files"], (Json{ "a-heat.nrrd", "a-labels.nrrd", "a-objects.nrrd", "a-objects.csv", "a.sh" }));
  const auto  labels = shapeton::ReadVolume(fixture.input.GetFolder() / "a-objects.nrrd").image;
  const Json  objects = fixture.Do(R"({"do": "objects", "choose": false})")["objects"];
  const auto  voxels = static_cast<std::ptrdiff_t>(labels->GetBufferedRegion().GetNumberOfPixels());
  const float last = static_cast<float>(objects.size());
  EXPECT_EQ(std::count(labels->GetBufferPointer(), labels->GetBufferPointer() + voxels, last),
            objects.back()["voxels"]); // the smallest object has no other in it
  const auto mask = shapeton::ReadVolume(fixture.input.GetFolder() / "one-object.nrrd").image;
  EXPECT_EQ(std::count(mask->GetBufferPointer(), mask->GetBufferPointer() + voxels, 1.0F), objects[1]["voxels"]);
  const std::string results = fixture.input.GetFolder() / "results";
  const int         status = RunScript(fixture.input.GetFolder() / "a.sh", results);
  if (status < 0)
  {
    GTEST_SKIP() << "the tools have not been built";
  }
  EXPECT_EQ(status, 0);
  ExpectSameFiles(fixture.input.GetFolder() / "",
                  results + "/",
                  { "a-heat.nrrd",
                    "a-labels.nrrd",
                    "a-objects.nrrd",
                    "a-objects.csv",
                    "one-heat.nrrd",
                    "one-object.nrrd",
                    "one-object.csv" });
}

TEST(LiveSession, HeatFlowsAroundABarrierAndTheToolsRepeatIt)
{
  Fixture fixture(3);
  EXPECT_NE(ErrorOf(fixture, R"({"do": "exclude", "region": "everywhere"})"), "");
  EXPECT_NE(ErrorOf(fixture, R"({"do": "exclude", "region": "selected"})"), "");
  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  fixture.Do(R"({"do": "select", "object": 2})"); // the ball
  fixture.Do(R"({"do": "save", "name": "ball", "selected": true})");
  const auto voxels = fixture.Do(R"({"do": "objects"})")["objects"][1]["voxels"].get<std::uint64_t>();
  fixture.Do(R"({"do": "exclude", "region": "selected"})");
  EXPECT_EQ(fixture.session.GetState()["lastChange"],
            "exclude selected: barrier 0 -> " + std::to_string(voxels) + " voxels");
  const auto middle = fixture.input.PointOf({ { 0, 0, 65 } });
  const Json plane = {
    { "do", "exclude" }, { "region", "plane" }, { "axis", 2 }, { "point", { middle[0], middle[1], middle[2] } }
  };
  fixture.session.Do(plane);
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["quality"], "exact");
  fixture.Do(R"({"do": "objects"})");
  fixture.Finish();
  const Json objects = fixture.Do(R"({"do": "objects"})")["objects"];
  EXPECT_EQ(objects[0]["voxels"], 18 * 24 * 27); // the box
  fixture.Do(R"({"do": "select", "object": 1})");
  const Json saved =
    fixture.Do(R"({"do": "save", "name": "around", "labels": true, "objects": true, "selected": true})");
  const auto heat = shapeton::ReadVolume(fixture.input.GetFolder() / "around-heat.nrrd").image;
  const auto ball = shapeton::ReadVolume(fixture.input.GetFolder() / "ball-object.nrrd").image;
  const auto barrier = shapeton::ReadVolume(fixture.input.GetFolder() / "barrier-1.nrrd").image;
  for (std::size_t i = 0; i < heat->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    const bool isBarrier = ball->GetBufferPointer()[i] != 0.0F || i / (std::size_t{ 72 } * 60) == 65;
    ASSERT_EQ(barrier->GetBufferPointer()[i] != 0.0F, isBarrier) << i;
    ASSERT_TRUE(!isBarrier || heat->GetBufferPointer()[i] == 0.0F) << i;
  }
  fixture.Do(R"({"do": "undo"})");
  EXPECT_NE(std::string(fixture.session.GetState()["lastChange"]).find("-> " + std::to_string(voxels) + " voxels"),
            std::string::npos);
  fixture.Do(R"({"do": "undo"})");
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "again"})");
  const auto before = shapeton::ReadVolume(fixture.input.GetFolder() / "ball-heat.nrrd").image;
  ExpectSameVoxels(shapeton::ReadVolume(fixture.input.GetFolder() / "again-heat.nrrd").image, before);

  const std::string results = fixture.input.GetFolder() / "results";
  const int         status = RunScript(fixture.input.GetFolder() / "again.sh", results);
  if (status < 0)
  {
    GTEST_SKIP() << "the tools have not been built";
  }
  EXPECT_EQ(status, 0);
  auto names = saved["files"].get<std::vector<std::string>>();
  ASSERT_EQ(names.back(), "around.sh");
  names.pop_back();
  ExpectSameFiles(fixture.input.GetFolder() / "", results + "/", names);
}

TEST(LiveSession, ClicksJoinObjectsOrRemoveThem)
{
  Fixture fixture(3);
  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  fixture.Do(R"({"do": "select", "object": 1})");
  const auto both = fixture.Do(R"({"do": "select", "object": 2, "add": true})");
  EXPECT_EQ(both["selection"], (Json{ 1, 2 }));
  EXPECT_EQ(both["selected"], 2);
  fixture.Do(R"({"do": "save", "name": "both", "selected": true})");
  const auto labels = shapeton::ReadVolume(fixture.input.GetFolder() / "both-object.nrrd").image;
  const auto begin = labels->GetBufferPointer();
  for (int object = 1; object <= 2; ++object)
  {
    EXPECT_EQ(std::count(begin, begin + std::size_t{ 72 } * 60 * 66, static_cast<float>(object)),
              both["objects"][object - 1]["voxels"]);
  }
  EXPECT_EQ(fixture.Do(R"({"do": "select", "object": 1, "add": true})")["selection"], (Json{ 2 }));
  EXPECT_EQ(fixture.Do(R"({"do": "select", "object": 1, "replace": true})")["selection"], (Json{ 1 }));
  EXPECT_NE(ErrorOf(fixture, R"({"do": "select", "object": 60000, "add": true})"), "");
  EXPECT_EQ(fixture.session.GetState()["selection"], (Json{ 1 }));
  EXPECT_EQ(fixture.Do(R"({"do": "select", "object": 0})")["selection"], Json::array());
}

TEST(LiveSession, SlicesHaveTheLabelsOfTheObjects)
{
  Fixture                 fixture(3);
  shapeton::SessionViewer viewer;
  viewer.place = { { 52, 31, 34 } }; // in the box
  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  const Frame frame(fixture.session.Update(viewer));
  std::size_t at = 0;
  for (const auto & slice : frame.header["slices"])
  {
    ASSERT_TRUE(slice["hasLabels"]);
    const int         axis = slice["axis"];
    const std::size_t size[] = { 72, 60, 66 };
    const std::size_t across = axis == 0 ? 1 : 0;
    const std::size_t down = axis == 2 ? 1 : 2;
    const std::size_t voxels = size[across] * size[down];
    const std::size_t here = viewer.place[down] * size[across] + viewer.place[across];
    std::uint16_t     label = 0;
    std::memcpy(&label, frame.arrays.data() + at + 3 * voxels + 2 * here, sizeof(label));
    EXPECT_EQ(label, 1);
    at += 5 * voxels; // bins, grays, labels
  }
}

TEST(LiveSession, AWholeFrameHasAllVoxelsAndTheLabelsOfObjects)
{
  Fixture                 fixture(3);
  shapeton::SessionViewer viewer;
  viewer.isWhole = true;
  fixture.Finish();
  const auto  voxels = std::size_t{ 72 } * 60 * 66;
  const Frame density(fixture.session.Update(viewer));
  ASSERT_EQ(density.arrays.size(), voxels * sizeof(float));
  fixture.Do(R"({"do": "save", "name": "w"})");
  const auto  visits = shapeton::ReadVolume(fixture.input.GetFolder() / "w-density.nrrd").image;
  const float greatest = *std::max_element(visits->GetBufferPointer(), visits->GetBufferPointer() + voxels);
  double      error = 0.0;
  for (std::size_t i = 0; i < voxels; ++i)
  {
    float value = 0.0F;
    std::memcpy(&value, density.arrays.data() + sizeof(value) * i, sizeof(value));
    error = std::max(error, std::abs(value - static_cast<double>(visits->GetBufferPointer()[i]) / greatest));
  }
  EXPECT_LT(error, 1e-6);
  const auto & grid = density.header["volume"];
  const auto   origin = fixture.input.PointOf({ { 0, 0, 0 } });
  EXPECT_EQ(grid["size"], (Json{ 72, 60, 66 }));
  EXPECT_EQ(grid["origin"], (Json{ origin[0], origin[1], origin[2] }));

  Frame state(fixture.session.Update(viewer)); // of the saved files
  EXPECT_TRUE(state.arrays.empty());
  EXPECT_FALSE(fixture.session.IsNewFor(viewer));

  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  const Frame heat(fixture.session.Update(viewer));
  ASSERT_EQ(heat.arrays.size(), voxels * (sizeof(float) + sizeof(unsigned short)));
  EXPECT_EQ(heat.header["objects"], fixture.Do(R"({"do": "objects", "choose": false})")["objects"]);
  fixture.Do(R"({"do": "save", "name": "o", "objects": true})");
  const auto  labels = shapeton::ReadVolume(fixture.input.GetFolder() / "o-objects.nrrd").image;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < voxels; ++i)
  {
    unsigned short label = 0;
    std::memcpy(&label, heat.arrays.data() + sizeof(float) * voxels + sizeof(label) * i, sizeof(label));
    wrong += label != labels->GetBufferPointer()[i];
  }
  EXPECT_EQ(wrong, 0U);
  fixture.Do(R"({"do": "select", "object": 1})");
  const Frame selected(fixture.session.Update(viewer));
  EXPECT_FALSE(selected.header.contains("objects"));
  EXPECT_EQ(selected.header["state"]["selected"], 1);
}

TEST(LiveSession, ReportsAHeatWithoutObjects)
{
  Fixture fixture;
  fixture.Do(R"({"do": "set", "p": 0})"); // no edge, thus no heat
  fixture.Do(R"({"do": "heat", "timeSteps": 10})");
  fixture.Finish();
  fixture.Do(R"({"do": "objects", "choose": false})");
  fixture.Finish();
  EXPECT_NE(fixture.session.GetState()["error"], "");
  EXPECT_TRUE(fixture.session.GetState()["objects"].is_null());
  fixture.Do(R"({"do": "heat", "timeSteps": 20})");
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["error"], "");
  EXPECT_EQ(fixture.session.GetState()["quality"], "exact");
}

TEST(LiveSession, ObjectsAreFoundAndSelected)
{
  Fixture fixture(3);
  EXPECT_NE(ErrorOf(fixture, R"({"do": "select", "object": 1})").find("find them first"), std::string::npos);
  EXPECT_NE(ErrorOf(fixture, R"({"do": "objects", "choose": false})").find("show the heat first"), std::string::npos);
  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["shown"], "heat");
  const auto window = fixture.session.GetState()["options"]["intensityWindow"];
  EXPECT_GT(window[0].get<double>(), 3.0); // between noise and box
  EXPECT_LT(window[1].get<double>(), 100.0);
  const Json objects = fixture.Do(R"({"do": "objects", "choose": false})")["objects"];
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(fixture.session.GetState()["objects"], objects.size());

  const auto point = fixture.input.PointOf({ { 52, 31, 34 } }); // in the box
  const Json command = { { "do", "select" }, { "point", { point[0], point[1], point[2] } } };
  EXPECT_EQ(fixture.session.Do(command)["selected"], 1);
  EXPECT_EQ(objects[0]["voxels"], 18 * 24 * 27);
  fixture.Do(R"({"do": "start", "region": "selected"})");
  EXPECT_EQ(fixture.session.GetState()["region"], "selected");
  EXPECT_TRUE(fixture.session.GetState()["objects"].is_null()); // everything is computed again
  EXPECT_NE(ErrorOf(fixture, R"({"do": "start", "region": "selected"})").find("no object is selected"),
            std::string::npos);
}

TEST(LiveSession, FindingObjectsReportsWhatItChangesAndIsUndone)
{
  Fixture fixture(3);
  fixture.Finish();
  const auto before = fixture.session.GetState();
  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  const auto found = fixture.session.GetState();
  ASSERT_NE(found["options"]["p"], before["options"]["p"]);
  const std::string report = found["lastChange"];
  const auto        number = [](const Json & value) { return shapeton::CsvTable::Number(value.get<double>()); };
  const auto        window = [&](const Json & state) {
    const auto & ends = state["options"]["intensityWindow"];
    return "[" + number(ends[0]) + ", " + number(ends[1]) + "]";
  };
  EXPECT_NE(report.find("p 4 -> " + number(found["options"]["p"])), std::string::npos) << report;
  EXPECT_NE(report.find("intensityWindow " + window(before) + " -> " + window(found)), std::string::npos) << report;
  EXPECT_NE(report.find("time of heat 60 -> " + found["heatSteps"].dump() + " steps"), std::string::npos) << report;
  EXPECT_EQ(report.find("seed"), std::string::npos) << report;

  fixture.Do(R"({"do": "undo"})");
  fixture.Finish();
  const auto undone = fixture.session.GetState();
  for (const std::string key : { "options", "heatSteps", "shown", "step" })
  {
    EXPECT_EQ(undone[key], before[key]) << key;
  }
  EXPECT_NE(ErrorOf(fixture, R"({"do": "undo"})"), "");
  fixture.Do(R"({"do": "save", "name": "u"})");
  ExpectSameVoxels(shapeton::ReadVolume(fixture.input.GetFolder() / "u-density.nrrd").image,
                   VisitsOfFilter(fixture, 60, fixture.input.Settings().walk));

  fixture.Do(R"({"do": "redo"})");
  fixture.Finish();
  const auto redone = fixture.session.GetState();
  for (const std::string key : { "options", "heatSteps", "shown", "quality" })
  {
    EXPECT_EQ(redone[key], found[key]) << key;
  }
  EXPECT_NE(ErrorOf(fixture, R"({"do": "redo"})"), "");
  fixture.Do(R"({"do": "save", "name": "u"})");
  const std::string script = shapeton::ReadFileBytes(fixture.input.GetFolder() / "u.sh");
  EXPECT_NE(script.find("# step 0: undo: "), std::string::npos) << script;
  EXPECT_NE(script.find(": " + report), std::string::npos) << script;
}

TEST(LiveSession, UndoGoesBackThroughAllChangesAndMovesOfASliderTogether)
{
  Fixture fixture;
  fixture.Do(R"({"do": "set", "p": 9})");
  for (const std::string steps : { "10", "20", "30" }) // a slider that moves
  {
    fixture.Do(R"({"do": "heat", "timeSteps": )" + steps + "}");
  }
  fixture.Do(R"({"do": "set", "p": 9})"); // changes nothing
  fixture.Do(R"({"do": "set", "p": 2, "seed": 8})");
  EXPECT_EQ(fixture.session.GetState()["undo"], 3);
  fixture.Do(R"({"do": "undo"})");
  EXPECT_EQ(fixture.session.GetState()["options"]["p"], 9);
  EXPECT_EQ(fixture.session.GetState()["heatSteps"], 30);
  fixture.Do(R"({"do": "undo"})");
  EXPECT_EQ(fixture.session.GetState()["shown"], "density");
  EXPECT_EQ(fixture.session.GetState()["heatSteps"], 60);
  fixture.Do(R"({"do": "undo"})");
  EXPECT_EQ(fixture.session.GetState()["options"]["p"], 4);
  EXPECT_EQ(fixture.session.GetState()["redo"], 3);
  fixture.Do(R"({"do": "redo"})");
  EXPECT_EQ(fixture.session.GetState()["options"]["p"], 9);
  fixture.Do(R"({"do": "set", "seed": 3})"); // nothing is left to redo
  EXPECT_EQ(fixture.session.GetState()["redo"], 0);
  EXPECT_EQ(fixture.session.GetState()["undo"], 2);
}

TEST(LiveSession, UndoStopsFindingObjects)
{
  Fixture    fixture;
  const Json before = fixture.session.GetState()["options"];
  fixture.Do(R"({"do": "objects", "choose": true})");
  EXPECT_TRUE(fixture.session.Work([&] { fixture.session.Interrupt(); })); // in the middle of the choice
  fixture.Do(R"({"do": "undo"})");
  fixture.Finish();
  EXPECT_EQ(fixture.session.GetState()["shown"], "density");
  EXPECT_EQ(fixture.session.GetState()["options"], before);
  EXPECT_TRUE(fixture.session.GetState()["objects"].is_null());
}

TEST(LiveSession, FindingObjectsOfItsOwnHeatAgainComputesNothing)
{
  Fixture fixture(3);
  fixture.Do(R"({"do": "objects", "choose": true})");
  fixture.Finish();
  const auto state = fixture.session.GetState();
  fixture.Do(R"({"do": "objects", "choose": true})");
  EXPECT_TRUE(fixture.session.Work());  // the parameters
  EXPECT_FALSE(fixture.session.Work()); // the objects
  const auto again = fixture.session.GetState();
  EXPECT_EQ(again["lastChange"], "Find objects: no value changes");
  EXPECT_EQ(again["objects"], state["objects"]);
  EXPECT_EQ(again["quality"], "exact");
}

TEST(LiveSession, UsesTheChoiceThatWasMadeAtItsStart)
{
  const basetest::SessionInput input(3);
  const auto                   volume = input.Volume();
  const auto choice = shapeton::ChooseShapetonParameters(shapeton::VolumeView(volume.image.GetPointer()), {}, {});
  std::vector<Json> states;
  for (const bool isGiven : { false, true })
  {
    auto settings = input.Settings();
    if (isGiven)
    {
      settings.choice = choice.heat;
    }
    LiveSession session(input.Volume(), settings);
    session.Do(Json::parse(R"({"do": "objects", "choose": true})"));
    if (isGiven)
    {
      int polls = 0;
      session.Work([&] { ++polls; });
      EXPECT_EQ(polls, 0); // a diffusion polls
    }
    while (session.Work())
    {}
    states.push_back(session.GetState());
  }
  EXPECT_EQ(states[0], states[1]);
}

TEST(LiveSession, ALaterChangeCancelsFindingObjects)
{
  for (const std::string change : { R"({"do": "set", "p": 7})",
                                    R"({"do": "start", "region": "everywhere"})",
                                    R"({"do": "density"})",
                                    R"({"do": "heat", "timeSteps": 50})" })
  {
    Fixture    fixture;
    const Json before = fixture.session.GetState()["options"];
    fixture.Do(R"({"do": "objects", "choose": true})");
    EXPECT_TRUE(fixture.session.Work([&] { fixture.session.Interrupt(); })) << change; // in the middle of the choice
    fixture.Do(change);
    fixture.Finish();
    fixture.Do(R"({"do": "heat", "timeSteps": 50})");
    fixture.Finish();
    const Json state = fixture.session.GetState();
    Json       expected = before;
    expected["p"] = change.find("set") == std::string::npos ? before["p"] : Json(7.0);
    EXPECT_EQ(state["options"], expected) << change;
    EXPECT_EQ(state["heatSteps"], 50) << change;
    EXPECT_EQ(state["quality"], "exact") << change;
    EXPECT_TRUE(state["objects"].is_null()) << change;
  }
}

TEST(LiveSession, ShowingDensityCancelsFindingObjectsOfThisHeat)
{
  Fixture fixture;
  fixture.Do(R"({"do": "heat", "timeSteps": 50})");
  fixture.Finish();
  fixture.Do(R"({"do": "objects", "choose": false})");
  fixture.Do(R"({"do": "density"})");
  fixture.Do(R"({"do": "heat", "timeSteps": 50})");
  EXPECT_FALSE(fixture.session.Work()); // the exact heat is still known
  EXPECT_TRUE(fixture.session.GetState()["objects"].is_null());
}

TEST(LiveSession, SurvivesAThousandRandomCommands)
{
  Fixture                 fixture;
  std::mt19937            random(62);
  shapeton::SessionViewer viewer;
  int                     accepted = 0;
  for (int i = 0; i < 1000; ++i)
  {
    accepted += ErrorOf(fixture, basetest::RandomCommand(random)).empty();
    for (auto pieces = random() % 3; pieces > 0; --pieces)
    {
      fixture.session.Work();
    }
    if (fixture.session.IsNewFor(viewer))
    {
      EXPECT_EQ(Frame(fixture.session.Update(viewer)).header["kind"], "update");
    }
  }
  EXPECT_GT(accepted, 500);
  fixture.Do(R"({"do": "speed", "stepsPerSecond": 0})");
  fixture.Do(R"({"do": "start", "region": "everywhere"})");
  fixture.Do(R"({"do": "set", "p": 3, "distance": 0.1, "shapetons": 777, "smoothing": 0, "placement": "uniform",
                 "pathRule": "endpoint", "seed": 5, "intensityWindow": [0, 103]})"); // it may have been chosen
  fixture.Do(R"({"do": "density"})");
  fixture.Do(R"({"do": "pause"})");
  fixture.Do(R"({"do": "step", "steps": 20})");
  fixture.Finish();
  fixture.Do(R"({"do": "save", "name": "last"})");
  auto walk = fixture.input.Settings().walk;
  walk.p = 3.0;
  walk.distance = 0.1;
  walk.intensityWindow = { { 0.0, 103.0 } };
  walk.shapetons = 777;
  walk.seed = 5;
  ExpectSameVoxels(shapeton::ReadVolume(fixture.input.GetFolder() / "last-density.nrrd").image,
                   VisitsOfFilter(fixture, 20, walk));
}
} // namespace
