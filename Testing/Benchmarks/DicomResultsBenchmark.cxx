// Time of each DICOM object of an examination, and of all objects. Usage: DicomResultsBenchmark [EXAM SOURCE]; without
// arguments, a phantom of 512 x 512 x 400 voxels is generated and analyzed first with the tools next to this program,
// which takes many minutes. Times are CPU seconds of one thread.
#include "Times.h"

#include "shapetonTestFolder.h"

#include "shapetonColonDicomResults.h"

#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
namespace fs = std::filesystem;

double
Megabytes(const std::string & path)
{
  return static_cast<double>(fs::file_size(path)) / 1e6;
}

struct Stage
{
  std::string name;
  double      begin;
};

using Objects = shapeton::ColonDicomObjectOptions;

/** Stages of writing all objects into `folder`; the last one marks the end. */
std::vector<Stage>
WriteAll(const std::string & exam, const std::string & source, const std::string & folder, const Objects & objects)
{
  fs::create_directories(folder);
  std::vector<Stage>          stages;
  shapeton::ColonDicomOptions options{ objects, {}, {} };
  const Stopwatch             watch;
  options.progress = [&](const std::string & name, double) { stages.push_back({ name, watch.ProcessorSeconds() }); };
  shapeton::WriteColonDicomResults(exam, source, folder, options, [](const std::string & path) { return path; });
  return stages;
}

/** Prints times and the sizes of the segmentations, each at most `megabytes`. */
void
Measure(const std::string & exam,
        const std::string & source,
        const std::string & folder,
        const char *        name,
        const Objects &     objects,
        double              megabytes)
{
  const std::vector<Stage> stages = WriteAll(exam, source, folder, objects);
  const double             whole = stages.back().begin - stages.front().begin;
  std::printf("all objects, segmentations %s: %.2f s\n", name, whole);
  for (std::size_t i = 0; i + 1 < stages.size(); ++i)
  {
    const double seconds = stages[i + 1].begin - stages[i].begin;
    std::printf("  %-20s %6.2f s, %4.1f %% of the whole\n", stages[i].name.c_str(), seconds, 100.0 * seconds / whole);
    if (stages[i].name.rfind("seg", 0) == 0)
    {
      PrintBound((stages[i].name + ": finding, packing and writing its segments, s").c_str(), seconds, 5.0);
      PrintBound((stages[i].name + ", MB").c_str(), Megabytes(folder + '/' + stages[i].name), megabytes);
    }
  }
}

void
Run(const std::string & command)
{
  if (std::system((command + " --quiet").c_str()) != 0)
  {
    throw std::runtime_error("command failed: " + command);
  }
}

/** A run and its source series. */
std::pair<std::string, std::string>
MakePhantomRun(const std::string & tools, const basetest::Folder & folder)
{
  std::printf("generating and analyzing a phantom of 512 x 512 x 400 voxels\n");
  std::fflush(stdout);
  const std::string source = folder / "series";
  const std::string exam = folder / "exam";
  Run(tools + "/ColonPhantom " + source + " --size 512,512,400 --seed 1");
  Run(tools + "/VirtualColonoscopy " + source + ' ' + exam);
  return { exam, source };
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 1 && argc != 3)
  {
    std::fprintf(stderr, "usage: %s [EXAM SOURCE]\n", argv[0]);
    return 2;
  }
  try
  {
    const basetest::Folder folder;
    const auto             run = argc == 3 ? std::make_pair(std::string(argv[1]), std::string(argv[2]))
                                           : MakePhantomRun(fs::canonical("/proc/self/exe").parent_path(), folder);
    Objects                plain, deflated, map, deflatedMap;
    deflated.deflate = deflatedMap.deflate = true;
    map.labelMap = deflatedMap.labelMap = true;
    Measure(run.first, run.second, folder / "plain", "binary", plain, 80.0);
    Measure(run.first, run.second, folder / "deflated", "binary, deflated", deflated, 8.0);
    Measure(run.first, run.second, folder / "map", "label maps, RLE", map, 8.0);
    Measure(run.first, run.second, folder / "deflatedMap", "label maps, deflated", deflatedMap, 1.5);
  }
  catch (const std::exception & error)
  {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
  return 0;
}
