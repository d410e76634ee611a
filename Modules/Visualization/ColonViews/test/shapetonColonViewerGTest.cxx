#include "shapetonColonViewer.h"

#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
using shapeton::ColonViewerOptions;
using shapeton::WriteColonViewer;

std::string
AsItIs(const std::string & path)
{
  return path;
}

void
Write(const ColonViewerOptions & options)
{
  const std::string folder = testing::TempDir() + "/no-examination";
  std::filesystem::create_directories(folder);
  WriteColonViewer(folder, testing::TempDir(), options, AsItIs);
}

std::string
FaultOf(const ColonViewerOptions & options)
{
  return basetest::ErrorOf([&] { Write(options); });
}
} // namespace

TEST(ColonViewer, RefusesAnExaminationThatIsNotFinished)
{
  const std::string fault = FaultOf({});
  EXPECT_NE(fault.find("no-examination"), std::string::npos) << fault;
  EXPECT_NE(fault.find("let VirtualColonoscopy finish it"), std::string::npos) << fault;
}

TEST(ColonViewer, RefusesOptionsOutOfRange)
{
  ColonViewerOptions bits;
  bits.bits = 12;
  EXPECT_THROW(Write(bits), shapeton::ParameterError);
  ColonViewerOptions near;
  near.near = -1.0;
  EXPECT_THROW(Write(near), shapeton::ParameterError);
  near.near = 101.0;
  EXPECT_THROW(Write(near), shapeton::ParameterError);
}
