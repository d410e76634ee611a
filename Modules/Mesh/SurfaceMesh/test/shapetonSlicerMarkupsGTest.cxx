#include "shapetonSlicerMarkups.h"

#include "shapetonFileBytes.h"
#include "shapetonJson.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace
{
using basetest::Folder;
using basetest::MessageOf;
using shapeton::Json;
using shapeton::Markup;

const double pi = std::acos(-1.0);

std::vector<Markup>
Examples()
{
  Markup points{ Markup::Kind::Points, "flexures", { { 1.5, -2.25, 1.0 / 3.0 }, { 4, 5, 6 } } };
  points.labels = { "splenic", "hepatic \"?\"" };
  points.descriptions = { "confidence 0.9", "" };
  points.color = { 0.25, 0.5, 1.0 };
  const Markup curve{ Markup::Kind::Curve, "centerline", { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 } } };
  const Markup loop{ Markup::Kind::ClosedCurve, "loop", { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } } };
  return { points, curve, loop };
}

bool
AreNumbers(const Json & array, std::size_t size, double least, double greatest)
{
  bool areNumbers = array.is_array() && array.size() == size;
  for (const Json & value : array)
  {
    areNumbers = areNumbers && value.is_number() && value >= least && value <= greatest;
  }
  return areNumbers;
}

/** What a property may hold, and the properties that hold it. */
using Schema = std::vector<std::pair<std::function<bool(const Json &)>, std::set<std::string>>>;

bool
IsText(const Json & value)
{
  return value.is_string();
}
bool
IsFlag(const Json & value)
{
  return value.is_boolean();
}
bool
IsNumber(const Json & value)
{
  return value.is_number() && value >= 0.0;
}
bool
IsColor(const Json & value)
{
  return AreNumbers(value, 3, 0.0, 1.0);
}

// Allowed properties of Slicer's schema 1.0.3.
const Schema markupSchema{ { IsText, { "type", "name", "coordinateSystem", "coordinateUnits", "labelFormat" } },
                           { IsFlag, { "locked", "fixedNumberOfControlPoints" } },
                           { [](const Json & value) { return value.is_array(); }, { "controlPoints" } },
                           { [](const Json & value) { return value.is_object(); }, { "display" } } };
const Schema pointSchema{ { IsText, { "id", "label", "description", "associatedNodeID", "positionStatus" } },
                          { [](const Json & value) { return AreNumbers(value, 3, -1e300, 1e300); }, { "position" } },
                          { [](const Json & value) { return AreNumbers(value, 9, -1.0, 1.0); }, { "orientation" } },
                          { IsFlag, { "selected", "locked", "visibility" } } };
const Schema displaySchema{ { IsFlag,
                              { "visibility", "propertiesLabelVisibility", "pointLabelsVisibility", "useGlyphScale" } },
                            { IsNumber, { "opacity", "textScale", "glyphSize", "lineThickness" } },
                            { IsColor, { "color", "selectedColor" } },
                            { IsText, { "glyphType" } } };

void
ExpectSchema(const Json & object, const Schema & schema)
{
  for (const auto & item : object.items())
  {
    const auto kind = std::find_if(
      schema.begin(), schema.end(), [&](const auto & candidate) { return candidate.second.count(item.key()) > 0; });
    ASSERT_NE(kind, schema.end()) << item.key();
    EXPECT_TRUE(kind->first(item.value())) << item.key() << ": " << item.value();
  }
}

TEST(SlicerMarkups, FollowTheSchemaOfSlicer)
{
  const Folder folder;
  shapeton::WriteMarkups(Examples(), folder / "a.mrk.json");
  const Json        document = shapeton::ReadJson(folder / "a.mrk.json");
  const std::string schema = document["@schema"];
  EXPECT_NE(schema.find("markups-schema-v1.0.3.json#"), std::string::npos);
  ASSERT_EQ(document["markups"].size(), 3u);
  const std::vector<std::string> types{ "Fiducial", "Curve", "ClosedCurve" };
  for (int i = 0; i < 3; ++i)
  {
    const Json & markup = document["markups"][i];
    EXPECT_EQ(markup["type"], types[i]);
    EXPECT_EQ(markup["coordinateSystem"], "LPS");
    ExpectSchema(markup, markupSchema);
    ExpectSchema(markup["display"], displaySchema);
    for (const Json & point : markup["controlPoints"])
    {
      ExpectSchema(point, pointSchema);
      EXPECT_EQ(point["positionStatus"], "defined");
    }
  }
  EXPECT_EQ(document["markups"][1]["controlPoints"][2]["label"], "centerline-3");
}

TEST(SlicerMarkups, ComeBackAsTheyWere)
{
  const Folder folder;
  const auto   written = Examples();
  shapeton::WriteMarkups(written, folder / "a.mrk.json");
  const auto read = shapeton::ReadMarkups(folder / "a.mrk.json");
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i)
  {
    EXPECT_EQ(read[i].kind, written[i].kind);
    EXPECT_EQ(read[i].name, written[i].name);
    EXPECT_EQ(read[i].points, written[i].points);
    EXPECT_EQ(read[i].color, written[i].color);
  }
  EXPECT_EQ(read[0].labels, written[0].labels);
  EXPECT_EQ(read[0].descriptions, written[0].descriptions);
  shapeton::WriteMarkups(read, folder / "b.mrk.json");
  EXPECT_EQ(shapeton::ReadFileBytes(folder / "a.mrk.json"), shapeton::ReadFileBytes(folder / "b.mrk.json"));
}

/** One markup with these members, as Slicer may save it. */
std::string
FileWith(const Folder & folder, const std::string & members)
{
  const std::string path = folder / "x.mrk.json";
  shapeton::WriteFileBytes(
    path, R"({"@schema": "https://example.org/markups-schema-v1.0.0.json#", "markups": [{)" + members + "}]}");
  return path;
}

TEST(SlicerMarkups, RasAndMicrometersBecomeLpsMillimeters)
{
  const Folder folder;
  const auto   markups =
    shapeton::ReadMarkups(FileWith(folder,
                                   R"("type": "Fiducial", "coordinateSystem": "RAS", "coordinateUnits":
      ["um", "UCUM", "micrometer"], "controlPoints": [{"position": [1000, -2000, 3000]}])"));
  ASSERT_EQ(markups.size(), 1u);
  EXPECT_TRUE(markups[0].points.at(0).isApprox(Eigen::Vector3d(-1.0, 2.0, 3.0)));
  EXPECT_EQ(markups[0].labels, std::vector<std::string>{ "" });
}

TEST(SlicerMarkups, PointsThatWereNotPlacedAndBoxesAreLeftOut)
{
  const Folder folder;
  const auto   markups = shapeton::ReadMarkups(FileWith(folder,
                                                      R"("type": "ROI", "controlPoints": [{"position": [9, 9, 9]}]},
      {"type": "Fiducial", "controlPoints": [{"position": [], "positionStatus": "undefined"},
      {"position": [0, 0, 0], "positionStatus": "preview"}, {"position": [1, 2, 3], "positionStatus": "defined"}])"));
  ASSERT_EQ(markups.size(), 1u);
  ASSERT_EQ(markups[0].points.size(), 1u);
  EXPECT_EQ(markups[0].points[0], Eigen::Vector3d(1, 2, 3));
}

TEST(SlicerMarkups, FaultyFilesAreRefusedByName)
{
  const Folder folder;
  for (const std::string members : { R"("type": "Fiducial", "controlPoints": [])",
                                     R"("type": "Fiducial", "controlPoints": [{"position": [1, 2]}])",
                                     R"("type": "Fiducial", "controlPoints": [{"position": [1, "a", 2]}])",
                                     R"("type": "Fiducial", "controlPoints": [3])",
                                     R"("type": "Fiducial", "controlPoints": {"position": 3})",
                                     R"("type": 5)",
                                     R"("name": "no type")",
                                     R"("type": "Curve", "coordinateUnits": "cm", "controlPoints": [])",
                                     R"("type": "Curve", "coordinateUnits": [], "controlPoints": [])",
                                     R"("type": "Curve", "coordinateSystem": "IJK", "controlPoints": [])" })
  {
    const std::string path = FileWith(folder, members);
    const std::string message = MessageOf([&] { shapeton::ReadMarkups(path); });
    EXPECT_EQ(message.substr(0, 12), "InputError: ") << members;
    EXPECT_NE(message.find(path), std::string::npos) << message;
  }
  for (const std::string text : { "{}", "[]", "5", R"({"@schema": "other", "markups": []})", R"({"@schema": 1})", "{" })
  {
    shapeton::WriteFileBytes(folder / "y.mrk.json", text);
    EXPECT_EQ(MessageOf([&] { shapeton::ReadMarkups(folder / "y.mrk.json"); }).substr(0, 12), "InputError: ") << text;
  }
}

TEST(SlicerMarkups, WhatCannotBeShownIsRefusedWhenWritten)
{
  const Folder folder;
  EXPECT_EQ(MessageOf([&] { shapeton::WriteMarkups({}, folder / "a.json"); }).substr(0, 16), "ParameterError: ");
  auto few = Examples();
  few[0].labels.pop_back();
  EXPECT_THROW(shapeton::WriteMarkups(few, folder / "a.mrk.json"), std::invalid_argument);
  auto infinite = Examples();
  infinite[1].points[0].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(shapeton::WriteMarkups(infinite, folder / "a.mrk.json"), std::invalid_argument);
}

/** A circle of radius 10 mm with 360 vertices; the first is repeated if it is closed. */
shapeton::CurveSet
Circle(bool isClosed)
{
  shapeton::CurveSet circle;
  circle.V.resize(360, 3);
  circle.curves.resize(1);
  for (int i = 0; i < 360; ++i)
  {
    circle.V.row(i) << 10.0 * std::cos(pi * i / 180.0), 10.0 * std::sin(pi * i / 180.0), 0.0;
    circle.curves[0].push_back(i);
  }
  if (isClosed)
  {
    circle.curves[0].push_back(0);
  }
  return circle;
}

TEST(SlicerMarkups, CurvesAreThinnedButKeepTheirEnds)
{
  const Markup open = shapeton::MarkupOfCurve(Circle(false), 0, Markup::Kind::Curve, 5.0);
  EXPECT_EQ(open.points.front(), Eigen::Vector3d(Circle(false).V.row(0)));
  EXPECT_EQ(open.points.back(), Eigen::Vector3d(Circle(false).V.row(359)));
  for (std::size_t i = 1; i < open.points.size(); ++i)
  {
    EXPECT_LE((open.points[i] - open.points[i - 1]).norm(), 5.0);
  }
  EXPECT_NEAR(open.points.size(), 20.0 * pi / 5.0, 2.0);
}

TEST(SlicerMarkups, AClosedCurveDoesNotRepeatItsFirstPoint)
{
  const Markup loop = shapeton::MarkupOfCurve(Circle(true), 0, Markup::Kind::ClosedCurve, 5.0);
  EXPECT_NE(loop.points.front(), loop.points.back());
  EXPECT_LE((loop.points.front() - loop.points.back()).norm(), 5.0);
  EXPECT_EQ(shapeton::MarkupOfCurve(Circle(false), 0, Markup::Kind::Points).points.size(), 360u);
  EXPECT_THROW(shapeton::MarkupOfCurve(Circle(false), 1, Markup::Kind::Curve), std::invalid_argument);
}
} // namespace
