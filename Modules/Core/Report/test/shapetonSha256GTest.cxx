#include "shapetonSha256.h"
#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"

namespace
{
using basetest::MessageOf;
using basetest::Scratch;

// The examples of FIPS 180-2, appendix B, and of NIST's "Examples with intermediate values".
TEST(Sha256, OfTheExamplesOfItsStandard)
{
  EXPECT_EQ(shapeton::Sha256OfBytes(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(shapeton::Sha256OfBytes("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(shapeton::Sha256OfBytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(shapeton::Sha256OfBytes(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileIsThatOfItsBytes)
{
  const Scratch scratch;
  std::string   bytes;
  unsigned int  state = 1;
  for (int i = 0; i < (3 << 20) + 17; ++i) // more than one buffer, not a multiple of it, all values
  {
    state = state * 1664525u + 1013904223u;
    bytes += static_cast<char>(state >> 24);
  }
  for (const std::size_t size : { std::size_t(0), std::size_t(1), std::size_t(1) << 20, bytes.size() })
  {
    shapeton::WriteFileBytes("file", bytes.substr(0, size));
    EXPECT_EQ(shapeton::Sha256OfFile("file"), shapeton::Sha256OfBytes(bytes.substr(0, size)));
  }
  shapeton::WriteFileBytes("a million", std::string(1000000, 'a'));
  EXPECT_EQ(shapeton::Sha256OfFile("a million"), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileThatCannotBeRead)
{
  const Scratch scratch;
  EXPECT_EQ(MessageOf([] { shapeton::Sha256OfFile("missing"); }),
            "InputError: cannot read \"missing\": No such file or directory; check the name and its permissions");
  EXPECT_EQ(MessageOf([] { shapeton::Sha256OfFile("."); }),
            "InputError: cannot read \".\": Is a directory; specify a file");
}

TEST(FileBytes, ComeBackAsTheyWere)
{
  const Scratch scratch;
  std::string   bytes;
  for (int i = 0; i < 200000; ++i)
  {
    bytes += static_cast<char>(i % 251);
  }
  for (const std::string & content : { bytes, std::string("short"), std::string() }) // each file replaces a longer one
  {
    shapeton::WriteFileBytes("file", content);
    EXPECT_EQ(shapeton::ReadFileBytes("file"), content);
  }
}

TEST(FileBytes, ThatCannotBeReadOrWritten)
{
  const Scratch scratch;
  EXPECT_EQ(MessageOf([] { shapeton::ReadFileBytes("missing"); }),
            "InputError: cannot read \"missing\": No such file or directory; check the name and its permissions");
  EXPECT_EQ(MessageOf([] { shapeton::ReadFileBytes("."); }),
            "InputError: cannot read \".\": Is a directory; specify a file");
  EXPECT_EQ(MessageOf([] { shapeton::WriteFileBytes("no/file", "x"); }),
            "OutputError: cannot write \"no/file\": No such file or directory; use an existing, writable folder");
  EXPECT_EQ(MessageOf([] { shapeton::WriteFileBytes(".", "x"); }),
            "OutputError: cannot write \".\": Is a directory; specify a file name");
  for (const std::size_t size : { 1, 1 << 20 })
  {
    EXPECT_EQ(
      MessageOf([size] { shapeton::WriteFileBytes("/dev/full", std::string(size, 'x')); }),
      "OutputError: cannot write \"/dev/full\": No space left on device; free some space or choose another folder");
  }
}
} // namespace
