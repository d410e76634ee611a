#include "shapetonJson.h"
#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"

#include <cmath>
#include <limits>

namespace
{
using basetest::Folder;
using basetest::MessageOf;

/** Error message for a file with this content, with the name replaced. */
std::string
FaultOf(const std::string & text)
{
  const Folder      folder;
  const std::string path = folder / "x.json";
  shapeton::WriteFileBytes(path, text);
  std::string message = MessageOf([&] { shapeton::ReadJson(path); });
  if (const auto name = message.find('"' + path + '"'); name != std::string::npos)
  {
    message.replace(name, path.size() + 2, "FILE");
  }
  return message;
}

TEST(Json, KeepsTheOrderOfItsKeysAndEndsWithANewline)
{
  const Folder   folder;
  shapeton::Json document;
  document["zebra"] = 1;
  document["ant"] = { 1.5, true, nullptr, "text" };
  document["empty"] = shapeton::Json::object();
  shapeton::WriteJson(document, folder / "a.json");
  EXPECT_EQ(
    shapeton::ReadFileBytes(folder / "a.json"),
    "{\n  \"zebra\": 1,\n  \"ant\": [\n    1.5,\n    true,\n    null,\n    \"text\"\n  ],\n  \"empty\": {}\n}\n");
  EXPECT_EQ(shapeton::ReadJson(folder / "a.json"), document);
  EXPECT_EQ(shapeton::ReadJson(folder / "a.json").begin().key(), "zebra");
}

TEST(Json, NumbersAndTextsComeBack)
{
  const Folder   folder;
  shapeton::Json document = shapeton::Json::array();
  for (const double value : { 0.1, 1.0 / 3.0, 1e-300, -5e-324, std::numeric_limits<double>::max() })
  {
    document.push_back(value);
  }
  document.push_back(std::numeric_limits<std::int64_t>::min());
  document.push_back("quote \" backslash \\ newline \n nul " + std::string(1, '\0') + " \xC3\xA4 \xF0\x9F\xA6\xB4");
  shapeton::WriteJson(document, folder / "a.json");
  EXPECT_EQ(shapeton::ReadJson(folder / "a.json"), document);
}

TEST(Json, WhatItCannotHoldIsReplaced)
{
  const Folder folder;
  shapeton::WriteJson({ { "bytes", "a\xFFz" }, { "nan", std::nan("") } }, folder / "a.json");
  const shapeton::Json document = shapeton::ReadJson(folder / "a.json");
  EXPECT_EQ(document.at("bytes"), "a\xEF\xBF\xBDz");
  EXPECT_TRUE(document.at("nan").is_null());
}

TEST(Json, MeasuredValuesAreRounded)
{
  EXPECT_EQ(shapeton::RoundedJson(123456.789).dump(), "123457.0");
  EXPECT_EQ(shapeton::RoundedJson(-0.00012345678, 3).dump(), "-0.000123");
  EXPECT_EQ(shapeton::RoundedJson(0.0).dump(), "0.0");
  EXPECT_TRUE(shapeton::RoundedJson(std::nan("")).is_null());
}

TEST(Json, FaultsHaveAPlace)
{
  EXPECT_EQ(FaultOf(""), "InputError: FILE is not valid JSON at line 1, column 1; correct the file there");
  EXPECT_EQ(FaultOf("x"), "InputError: FILE is not valid JSON at line 1, column 1; correct the file there");
  EXPECT_EQ(FaultOf("{\n  \"a\": 1,\n  \"b\" 2\n}\n"),
            "InputError: FILE is not valid JSON at line 3, column 7; correct the file there");
  EXPECT_EQ(FaultOf("[1, 2\n"), "InputError: FILE is not valid JSON at line 2, column 1; correct the file there");
  EXPECT_EQ(FaultOf("[1] 2"), "InputError: FILE is not valid JSON at line 1, column 5; correct the file there");
  EXPECT_EQ(FaultOf("[NaN]"), "InputError: FILE is not valid JSON at line 1, column 2; correct the file there");
  EXPECT_EQ(FaultOf("[\"\xFF\"]"), "InputError: FILE is not valid JSON at line 1, column 3; correct the file there");
  EXPECT_EQ(FaultOf("[1e999]"), "InputError: FILE contains a number that is too large; correct the file");
}

TEST(Json, RepeatedKeysOfOneObjectAreRefused)
{
  EXPECT_EQ(FaultOf("{\"a\": 1, \"b\": {\"a\": 2}, \"c\": [{\"a\": 3}, {\"a\": 4}]}"), "no error");
  EXPECT_EQ(FaultOf("{\"a\": 1, \"b\": [{\"c\": 2, \"d\": {}, \"c\": 2}]}"),
            "InputError: FILE: the entry \"c\" is repeated; remove one of the two");
}

TEST(Json, HostileFilesAreRefusedWithoutACrash)
{
  EXPECT_EQ(FaultOf(std::string(1000000, '[')),
            "InputError: FILE is not valid JSON at line 1, column 1000001; correct the file there");
  EXPECT_EQ(FaultOf(std::string(100000, '[') + std::string(100000, ']')), "no error");
}

TEST(Json, FilesThatCannotBeReadOrWritten)
{
  EXPECT_EQ(MessageOf([] { shapeton::ReadJson("missing.json"); }),
            "InputError: cannot read \"missing.json\": No such file or directory; check the name and its permissions");
  EXPECT_EQ(MessageOf([] { shapeton::ReadJson("."); }),
            "InputError: cannot read \".\": Is a directory; specify a file");
  EXPECT_EQ(
    MessageOf([] { shapeton::WriteJson({}, "/dev/full"); }),
    "OutputError: cannot write \"/dev/full\": No space left on device; free some space or choose another folder");
}
} // namespace
