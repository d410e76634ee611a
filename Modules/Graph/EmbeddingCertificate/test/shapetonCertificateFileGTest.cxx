#include "shapetonCertificateFixtures.h"
#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"

#include <limits>

using namespace certificatetest;

namespace
{
std::string
TextOf(const EmbeddingCertificate & certificate)
{
  const basetest::Folder folder;
  shapeton::WriteEmbeddingCertificate(certificate, folder / "certificate.json");
  return shapeton::ReadFileBytes(folder / "certificate.json");
}

EmbeddingCertificate
ReadText(const std::string & text)
{
  const basetest::Folder folder;
  shapeton::WriteFileBytes(folder / "certificate.json", text);
  return shapeton::ReadEmbeddingCertificate(folder / "certificate.json");
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
  const auto        refuses = [](const std::string & bytes, const std::string & message) {
    EXPECT_TRUE(basetest::Refuses([&] { ReadText(bytes); }, message)) << bytes.substr(0, 100);
  };
  refuses("", "line 1, column 1");
  refuses(text.substr(0, 500), "is not valid JSON at line");
  refuses("{}", "\"format\" is missing");
  refuses("[1, 2]", "\"format\" is missing");
  refuses(Replaced(text, "\"genus\": 1", "\"genus\": -1"), "\"genus\" is less than 0");
  refuses(Replaced(text, "euclidean", "flat"), "\"geometry\" is \"flat\"");
  refuses(Replaced(text, "\"tree\": [-1", "\"tree\": [99999"), "99999, which is out of range");
  refuses(Replaced(text, "\"nodeRadii\": [0.5,", "\"nodeRadii\": ["), "has 8 entries instead of 9");
  refuses(Replaced(text, "\"nodeRadii\": [0.5,", "\"nodeRadii\": [\"x\","), "holds \"x\", not a number");
  refuses(Replaced(text, "\"nodeRadii\": [0.5,", "\"nodeRadii\": [1e999,"), "too large");
  refuses(Replaced(text, "\"genus\": 1", "\"genus\": 1, \"genus\": 1"), "is repeated");
  refuses(Replaced(text, "\"version\": 1", "\"version\": 2"), "\"version\" is not 1");
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
