// Virtual colonoscopy of the lumen of a coarse synthetic patient: all stages with the tools next to this program, then
// one report. The options are read from the module description of the tool VirtualColonoscopy.
// Usage: ExampleColonoscopyRun FOLDER
#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonoscopyRun.h"
#include "shapetonCommandLine.h"
#include "shapetonExaminationFolder.h"
#include "shapetonFileBytes.h"
#include "shapetonStagedRun.h"
#include "shapetonVolumeWriter.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  std::filesystem::create_directories(folder);
  const auto phantom = shapeton::ColonPhantomImageSource::New();
  phantom->SetSize({ { 128, 128, 120 } });
  phantom->SetSpacing(shapeton::ColonPhantomImageSource::SpacingType(2.8)); // mm
  phantom->CenterOutput();
  phantom->TruthOnlyOn();
  phantom->Update();
  shapeton::WriteVolume(static_cast<const itk::Image<unsigned char, 3> *>(phantom->GetLumenOutput()),
                        folder + "/lumen.nrrd");

  const std::string  tools = shapeton::FolderOfThisProgram();
  const std::string  xml = shapeton::ReadFileBytes(tools + "/VirtualColonoscopy.xml");
  const std::string  lumen = folder + "/lumen.nrrd";
  const std::string  results = folder + "/results";
  const char * const arguments[] = { argv[0],       lumen.c_str(), results.c_str(), "--inputIsLumen",
                                     "--faces",     "8000",        "--metric",      "euclidean",
                                     "--pixelSize", "2",           "--quiet" };
  const int          status = shapeton::CommandLine::Run(
    xml.c_str(), static_cast<int>(std::size(arguments)), arguments, [&](shapeton::CommandLine & commandLine) {
      shapeton::RunColonoscopy(commandLine, tools);
    });
  if (status == 0)
  {
    const shapeton::ExaminationFolder exam(results);
    const shapeton::Json              quality = exam.ReadQuality();
    const shapeton::Json              landmarks = exam.ReadLandmarks();
    std::cout << "centerline of " << std::lround(quality["centerline"]["length"].get<double>()) << " mm, wall of genus "
              << quality["surface"]["genusRepaired"] << ", " << landmarks["segments"].size() << " segments; report of "
              << std::filesystem::file_size(exam.PathOf(shapeton::examination::report)) / 1000 << " kB\n";
  }
  return status;
}
