#ifndef shapetonVolumeTesting_h
#define shapetonVolumeTesting_h

#include "shapetonDicomFixture.h"
#include "shapetonDicomSeriesScan.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeReader.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace shapeton
{
/** A new folder for the running test. */
inline std::string
TestFolder()
{
  const auto * const info = ::testing::UnitTest::GetInstance()->current_test_info();
  return MakeFolder(std::string(SHAPETON_TEST_TEMPORARY_DIR) + "/DicomSeries/" + info->test_suite_name() + "." +
                    info->name());
}

/** The scan of files in a new folder. */
inline DicomScan
ScanOf(const DicomFixture::Files & files, const std::string & folder = TestFolder())
{
  SaveDicom(files, folder);
  return ScanDicom(folder);
}

/** The message of the InputError thrown by a call; fails if none is thrown. */
inline std::string
InputErrorOf(const std::function<void()> & call)
{
  try
  {
    call();
  }
  catch (const InputError & error)
  {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

/** The largest deviation of a volume from a function of position. */
inline double
LargestDeviation(const Volume & volume, const std::function<double(const DicomFixture::PointType &)> & intensity)
{
  double     largest = 0;
  const auto region = volume.image->GetLargestPossibleRegion();
  basetest::ForVoxels(volume.image, [&](const auto & index, const auto & point) {
    largest = std::max(largest, std::abs(volume.image->GetPixel(index) - intensity(point)));
  });
  return largest;
}

inline bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace shapeton

#endif
