#ifndef shapetonPictureTestUtilities_h
#define shapetonPictureTestUtilities_h

#include "shapetonFileBytes.h"
#include "shapetonPicture.h"
#include "shapetonTestThreads.h"

#include "itkImageFileReader.h"
#include "itkPNGImageIO.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace shapeton
{
/** Creates an empty folder for the files of one test. */
inline std::string
TemporaryFolder(const std::string & name)
{
  const std::string folder = std::string(SHAPETON_TEST_TEMPORARY_DIR) + "/ShapeRendering/" + name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline Picture::Pointer
ReadPng(const std::string & path)
{
  auto reader = itk::ImageFileReader<Picture>::New();
  reader->SetImageIO(itk::PNGImageIO::New());
  reader->SetFileName(path);
  reader->Update();
  return reader->GetOutput();
}

inline RGBColor
At(const Picture * picture, int x, int y)
{
  return picture->GetPixel({ { x, y } });
}

/** Largest channel difference of two pictures; 256 if their sizes differ. */
inline int
GreatestDifference(const Picture * a, const Picture * b)
{
  if (a->GetBufferedRegion() != b->GetBufferedRegion())
  {
    return 256;
  }
  int greatest = 0;
  for (itk::SizeValueType i = 0; i < a->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    for (unsigned int channel = 0; channel < 3; ++channel)
    {
      greatest = std::max(greatest, std::abs(a->GetBufferPointer()[i][channel] - b->GetBufferPointer()[i][channel]));
    }
  }
  return greatest;
}

/** Writes a picture to Testing/Temporary, for itkTestDriver, and compares all its channels with the
 * baseline. */
inline void
ExpectBaseline(const Picture * picture, const std::string & name)
{
  std::filesystem::create_directories(SHAPETON_TEST_TEMPORARY_DIR);
  WritePng(picture, std::string(SHAPETON_TEST_TEMPORARY_DIR) + "/" + name);
  const auto baseline = ReadPng(std::string(SHAPETON_BASELINE_DIR) + "/" + name);
  EXPECT_LE(GreatestDifference(picture, baseline), 1) << name;
}
} // namespace shapeton

#endif
