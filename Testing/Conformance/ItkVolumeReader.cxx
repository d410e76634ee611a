// ItkVolumeReader INPUT OUTPUT.nii: reads a file or a DICOM folder as the examples of ITK do.
#include "itkGDCMImageIO.h"
#include "itkGDCMSeriesFileNames.h"
#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
#include "itkImageSeriesReader.h"

#include <filesystem>
#include <iostream>

namespace
{
using ImageType = itk::Image<float, 3>;

ImageType::Pointer
ReadSeries(const std::string & folder)
{
  auto names = itk::GDCMSeriesFileNames::New();
  names->SetUseSeriesDetails(true);
  names->SetRecursive(true);
  names->SetGlobalWarningDisplay(false);
  names->SetDirectory(folder);
  std::vector<std::string> files;
  for (const std::string & series : names->GetSeriesUIDs())
  {
    const std::vector<std::string> some = names->GetFileNames(series);
    files = some.size() > files.size() ? some : files;
  }
  if (files.empty())
  {
    throw std::runtime_error("no series");
  }
  auto reader = itk::ImageSeriesReader<ImageType>::New();
  reader->SetImageIO(itk::GDCMImageIO::New());
  reader->SetFileNames(files);
  reader->Update();
  return reader->GetOutput();
}

ImageType::Pointer
ReadFile(const std::string & path)
{
  auto reader = itk::ImageFileReader<ImageType>::New();
  reader->SetFileName(path);
  reader->Update();
  return reader->GetOutput();
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: ItkVolumeReader INPUT OUTPUT.nii\n";
    return 2;
  }
  try
  {
    auto writer = itk::ImageFileWriter<ImageType>::New();
    writer->SetInput(std::filesystem::is_directory(argv[1]) ? ReadSeries(argv[1]) : ReadFile(argv[1]));
    writer->SetFileName(argv[2]);
    writer->Update();
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return 3;
  }
  return 0;
}
