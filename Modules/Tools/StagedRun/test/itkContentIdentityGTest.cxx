#include "itkContentIdentity.h"

#include "itkFileBytes.h"
#include "itkTestFolder.h"
#include "itkSha256.h"

#include "gtest/gtest.h"

namespace
{
namespace fs = std::filesystem;
using basetest::Folder;

TEST(ContentIdentity, OfAFileIsItsSha256)
{
  const Folder folder;
  itk::WriteFileBytes(folder / "a", "abc");
  EXPECT_EQ(itk::IdentityOf(folder / "a"), "sha256:ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(basetest::MessageOf([&] { itk::IdentityOf(folder / "none"); }).substr(0, 12), "InputError: ");
}

TEST(ContentIdentity, OfAFolderIsThatOfItsFilesAndTheirNames)
{
  const Folder folder;
  fs::create_directories(folder / "a/sub");
  itk::WriteFileBytes(folder / "a/x", "1");
  itk::WriteFileBytes(folder / "a/sub/y", "2");
  const std::string identity = itk::IdentityOf(folder / "a");
  fs::copy(folder / "a", folder / "b", fs::copy_options::recursive);
  EXPECT_EQ(itk::IdentityOf(folder / "b"), identity) << "the place does not count";
  itk::WriteFileBytes(folder / "b/.DS_Store", "noise");
  EXPECT_EQ(itk::IdentityOf(folder / "b"), identity) << "hidden files do not count";
  itk::WriteFileBytes(folder / "b/sub/y", "3");
  EXPECT_NE(itk::IdentityOf(folder / "b"), identity);
  fs::rename(folder / "a/x", folder / "a/z");
  EXPECT_NE(itk::IdentityOf(folder / "a"), identity);
}

TEST(ContentIdentity, AHeaderCountsWithItsVoxels)
{
  const Folder folder;
  itk::WriteFileBytes(folder / "a.mhd", "header");
  itk::WriteFileBytes(folder / "a.raw", "1");
  itk::WriteFileBytes(folder / "b.raw", "1");
  const std::string identity = itk::IdentityOf(folder / "a.mhd");
  itk::WriteFileBytes(folder / "b.raw", "2");
  EXPECT_EQ(itk::IdentityOf(folder / "a.mhd"), identity);
  itk::WriteFileBytes(folder / "a.raw", "2");
  EXPECT_NE(itk::IdentityOf(folder / "a.mhd"), identity);
}
} // namespace
