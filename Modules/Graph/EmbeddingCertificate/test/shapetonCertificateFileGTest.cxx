#include "shapetonCertificateFixtures.h"
#include "shapetonFileBytes.h"
#include "shapetonTestErrors.h"

#include "gtest/gtest.h"

#include <cstdio>
#include <filesystem>
#include <limits>
#include <unistd.h>

using namespace certificatetest;

namespace
{
class TemporaryFile
{
public:
  TemporaryFile()
    : path((std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "-certificate.json")).string())
  {}
  TemporaryFile(const TemporaryFile &) = delete;
  TemporaryFile &
  operator=(const TemporaryFile &) = delete;
  ~TemporaryFile() { std::remove(path.c_str()); }

  const std::string path;
};

std::string
TextOf(const EmbeddingCertificate & certificate)
{
  const TemporaryFile file;
  shapeton::WriteEmbeddingCertificate(certificate, file.path);
  return shapeton::ReadFileBytes(file.path);
}

EmbeddingCertificate
ReadText(const std::string & text)
{
  const TemporaryFile file;
  shapeton::WriteFileBytes(file.path, text);
  return shapeton::ReadEmbeddingCertificate(file.path);
}

std::string
MessageOf(const std::string & text)
{
  return basetest::ErrorOf([&] { ReadText(text); });
}

std::string
Replaced(std::string text, const std::string & old, const std::string & substitute)
{
  const auto place = text.find(old);
  return place == std::string::npos ? "nothing to replace" : text.replace(place, old.size(), substitute);
}
} // namespace

TEST(CertificateFile, ReadsBackToTheSameBytes)
{
  EmbeddingCertificate certificate = PathInTetrahedron();
  certificate.provenance = { { "tool", "a \"test\"\n" }, { "seed", "1" } };
  certificate.statistics = { { "residual", 1.25e-13 }, { "steps", 7 } };
  certificate.warnings = { "one", "two" };
  certificate.nodeRadii[0] = 0.1 + 0.2;
  const std::string text = TextOf(certificate);
  EXPECT_EQ(text, TextOf(ReadText(text)));
  EXPECT_EQ(0.1 + 0.2, ReadText(text).nodeRadii[0]);
  EXPECT_EQ(certificate.provenance, ReadText(text).provenance);
  for (const auto & whole : { TorusGrid(3, 4), Octagon(), Cube() })
  {
    EXPECT_EQ(TextOf(whole), TextOf(ReadText(TextOf(whole))));
  }
}

TEST(CertificateFile, NumbersThatAreNotFiniteAreNotWritten)
{
  EmbeddingCertificate certificate = Cube();
  certificate.nodeRadii[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(TextOf(certificate), std::invalid_argument);
}

TEST(CertificateFile, RefusalsNameTheEntry)
{
  const std::string text = TextOf(TorusGrid(3, 3));
  EXPECT_NE(std::string::npos, MessageOf("").find("line 1, column 1"));
  EXPECT_NE(std::string::npos, MessageOf(text.substr(0, 500)).find("is not valid JSON at line"));
  EXPECT_NE(std::string::npos, MessageOf("{}").find("\"format\" is missing"));
  EXPECT_NE(std::string::npos, MessageOf("[1, 2]").find("\"format\" is missing"));
  EXPECT_NE(std::string::npos,
            MessageOf(Replaced(text, "\"genus\": 1", "\"genus\": -1")).find("\"genus\" is less than 0"));
  EXPECT_NE(std::string::npos, MessageOf(Replaced(text, "euclidean", "flat")).find("\"geometry\" is \"flat\""));
  EXPECT_NE(std::string::npos,
            MessageOf(Replaced(text, "\"tree\": [-1", "\"tree\": [99999")).find("99999, which is out of range"));
  EXPECT_NE(std::string::npos,
            MessageOf(Replaced(text, "\"nodeRadii\": [0.5,", "\"nodeRadii\": [")).find("has 8 entries instead of 9"));
  EXPECT_NE(
    std::string::npos,
    MessageOf(Replaced(text, "\"nodeRadii\": [0.5,", "\"nodeRadii\": [\"x\",")).find("holds \"x\", not a number"));
  EXPECT_NE(std::string::npos,
            MessageOf(Replaced(text, "\"nodeRadii\": [0.5,", "\"nodeRadii\": [1e999,")).find("too large"));
  EXPECT_NE(std::string::npos,
            MessageOf(Replaced(text, "\"genus\": 1", "\"genus\": 1, \"genus\": 1")).find("is repeated"));
  EXPECT_NE(std::string::npos,
            MessageOf(Replaced(text, "\"version\": 1", "\"version\": 2")).find("\"version\" is not 1"));
}

TEST(CertificateFile, UnknownEntriesAreSkipped)
{
  const std::string text = TextOf(TorusGrid(3, 3));
  for (const std::string unknown :
       { "null", "[{\"x\": 1}, {\"x\": null}]", "{\"graph\": {\"edges\": [[null]]}}", "1e300" })
  {
    EXPECT_EQ(text, TextOf(ReadText(Replaced(text, "\"genus\": 1", "\"other\": " + unknown + ", \"genus\": 1"))))
      << unknown;
  }
}
