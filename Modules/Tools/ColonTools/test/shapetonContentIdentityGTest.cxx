#include "shapetonContentIdentity.h"

#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"
#include "shapetonSha256.h"

#include "gtest/gtest.h"

namespace
{
namespace fs = std::filesystem;
using basetest::Folder;

TEST(ContentIdentity, OfAFileIsItsSha256)
{
  const Folder folder;
  shapeton::WriteFileBytes(folder / "a", "abc");
  EXPECT_EQ(shapeton::IdentityOf(folder / "a"),
            "sha256:ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(basetest::MessageOf([&] { shapeton::IdentityOf(folder / "none"); }).substr(0, 12), "InputError: ");
}

TEST(ContentIdentity, OfAFolderIsThatOfItsFilesAndTheirNames)
{
  const Folder folder;
  fs::create_directories(folder / "a/sub");
  shapeton::WriteFileBytes(folder / "a/x", "1");
  shapeton::WriteFileBytes(folder / "a/sub/y", "2");
  const std::string identity = shapeton::IdentityOf(folder / "a");
  fs::copy(folder / "a", folder / "b", fs::copy_options::recursive);
  EXPECT_EQ(shapeton::IdentityOf(folder / "b"), identity) << "the location is ignored";
  shapeton::WriteFileBytes(folder / "b/.DS_Store", "noise");
  EXPECT_EQ(shapeton::IdentityOf(folder / "b"), identity) << "hidden files are ignored";
  shapeton::WriteFileBytes(folder / "b/sub/y", "3");
  EXPECT_NE(shapeton::IdentityOf(folder / "b"), identity);
  fs::rename(folder / "a/x", folder / "a/z");
  EXPECT_NE(shapeton::IdentityOf(folder / "a"), identity);
}

TEST(ContentIdentity, AHeaderCountsWithItsVoxels)
{
  const Folder folder;
  shapeton::WriteFileBytes(folder / "a.mhd", "header");
  shapeton::WriteFileBytes(folder / "a.raw", "1");
  shapeton::WriteFileBytes(folder / "b.raw", "1");
  const std::string identity = shapeton::IdentityOf(folder / "a.mhd");
  shapeton::WriteFileBytes(folder / "b.raw", "2");
  EXPECT_EQ(shapeton::IdentityOf(folder / "a.mhd"), identity);
  shapeton::WriteFileBytes(folder / "a.raw", "2");
  EXPECT_NE(shapeton::IdentityOf(folder / "a.mhd"), identity);
}
} // namespace
