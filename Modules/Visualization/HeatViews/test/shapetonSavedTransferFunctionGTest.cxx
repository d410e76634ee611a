#include "shapetonSavedTransferFunction.h"

#include "shapetonTestErrors.h"
#include "shapetonFileBytes.h"

#include <gtest/gtest.h>

namespace
{
using shapeton::InputError;
using shapeton::ReadTransferFunction;

const std::string line = R"({"lower": 0.18359375, "upper": 0.25, "color": "#05bffa", "opacity": 0.6})";

std::string
Document(
  const std::string & lines,
  const std::string & head = R"("shapeton": "transfer function", "version": 1, "quantity": "heat", "timeStep": 7)")
{
  return "{" + head + R"(, "lines": [)" + lines + "]}";
}

std::string
FileWith(const std::string & text)
{
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path = testing::TempDir() + "/transfer-function-" + test + ".json"; // tests run in parallel
  shapeton::WriteFileBytes(path, text);
  return path;
}

std::string
FaultOf(const std::string & text)
{
  return basetest::ErrorOf([&] { ReadTransferFunction(FileWith(text)); });
}
} // namespace

TEST(SavedTransferFunction, IsReadWithoutLoss)
{
  const auto saved = ReadTransferFunction(FileWith(Document(line)));
  EXPECT_EQ(saved.quantity, "heat");
  EXPECT_EQ(saved.timeStep, 7U);
  EXPECT_EQ(saved.lines.ToText(), "0.18359375-0.25:#05bffa:0.6");
}

TEST(SavedTransferFunction, RefusesWhatThePageDoesNotSave)
{
  const std::pair<std::string, std::string> faults[] = {
    { "no text", "line 1" },
    { "[]", "it is not an object" },
    { Document(line, R"("version": 1)"), "lacks \"quantity\"" },
    { Document(line, R"("shapeton": "verdicts", "version": 1, "quantity": "heat", "timeStep": 7)"), "kind or version" },
    { Document(line, R"("shapeton": "transfer function", "version": 2, "quantity": "heat", "timeStep": 7)"),
      "kind or version" },
    { Document(line, R"("shapeton": "transfer function", "version": 1, "quantity": "cold", "timeStep": 7)"),
      "neither heat nor density" },
    { Document(line, R"("shapeton": "transfer function", "version": 1, "quantity": "heat", "timeStep": -7)"),
      "not a time step" },
    { Document(""), "not a non-empty list" },
    { Document("3"), "a line is not an object" },
    { Document(R"({"lower": 0.1, "upper": 0.2, "color": "#05bffa"})"), "a line lacks \"opacity\"" },
    { Document(R"({"lower": "0.1", "upper": 0.2, "color": "#05bffa", "opacity": 1})"), "\"lower\" is not a number" },
    { Document(R"({"lower": 0.1, "upper": 0.2, "color": "rouge", "opacity": 1})"), "not a color" },
    { Document(R"({"lower": 0.1, "upper": 0.2, "color": "red", "opacity": 1, "shade": 1})"), "unknown key \"shade\"" },
    { Document(line + "," + line), "overlap" },
    { Document(R"({"lower": 0.3, "upper": 0.2, "color": "red", "opacity": 1})"), "0 <= a < b <= 1" },
  };
  for (const auto & [text, fault] : faults)
  {
    const std::string message = FaultOf(text);
    EXPECT_NE(message.find("transfer-function-"), std::string::npos) << text;
    EXPECT_NE(message.find(fault), std::string::npos) << text << " gives " << message;
  }
}

TEST(SavedTransferFunction, ObjectsAreWrittenAndRead)
{
  const shapeton::ObjectColor toe{ 4, { 4, 12 }, 35935, shapeton::MakeColor(255, 128, 0), 0.25 };
  const std::string           path = FileWith("");
  shapeton::WriteTransferFunction({ "heat", 9, {}, { toe } }, path);
  const auto saved = ReadTransferFunction(path);
  EXPECT_TRUE(saved.lines.GetLines().empty());
  ASSERT_EQ(saved.objects.size(), 1U);
  EXPECT_EQ(shapeton::TextOf(saved.objects), "4:#ff8000:0.25");
  EXPECT_EQ(saved.objects[0].labels, toe.labels);
  EXPECT_EQ(saved.objects[0].voxels, toe.voxels);
}

TEST(SavedTransferFunction, RefusesWrongObjects)
{
  const std::string head =
    R"("shapeton": "transfer function", "version": 2, "quantity": "heat", "timeStep": 7, "objects": )";
  const auto with = [&](const std::string & numbers, const std::string & opacity) {
    return Document("", head + "[{" + numbers + R"(, "color": "#05bffa", "opacity": )" + opacity + "}]");
  };
  const std::string good = R"("number": 1, "labels": [1], "voxels": 5)";
  EXPECT_NO_THROW(ReadTransferFunction(FileWith(with(good, "1"))));
  const std::pair<std::string, std::string> faults[] = {
    { Document("", head + "[]"), "\"objects\" is not a non-empty list" },
    { Document("", head + "[3]"), "an object is not an object" },
    { with(good, "2"), "the opacity of object 1 is not from 0 to 1" },
    { with(R"("number": 0, "labels": [1], "voxels": 5)", "1"), "is not from 1 to 65535" },
    { with(R"("number": 1, "labels": [70000], "voxels": 5)", "1"), "is not from 1 to 65535" },
    { with(R"("number": 1, "labels": [], "voxels": 5)", "1"), "\"labels\" is not a non-empty list" },
    { with(R"("number": 1, "labels": [1], "voxels": -5)", "1"), "not a number of voxels" },
    { with(R"("number": 1, "voxels": 5)", "1"), "lacks \"labels\"" },
  };
  for (const auto & [text, fault] : faults)
  {
    EXPECT_NE(FaultOf(text).find(fault), std::string::npos) << text << " gives " << FaultOf(text);
  }
}

TEST(SavedTransferFunction, RefusesAMissingFile)
{
  EXPECT_THROW(ReadTransferFunction(testing::TempDir() + "/nowhere.json"), InputError);
}
