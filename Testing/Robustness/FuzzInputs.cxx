// FuzzInputs --files N --seed S [--kind all|volumes|graphs|files|results|runs] [--exam RUN] [--folder DIR]
//
// Mutates DICOM files, NRRD, NIfTI and MetaImage files, surfaces, graphs and embedding certificates, and passes them to
// the readers (and readable certificates to the verifier). --kind graphs: only graphs and certificates; --kind volumes:
// only volumes and surfaces; --kind files: only images, surfaces and graphs that are not DICOM; --kind results: only
// DICOM segmentations and reports; --kind runs: only the files of the virtual colonoscopy in RUN. A reader may read a
// mutant or reject it with an InputError. It must not crash, hang, use unbounded memory, or cause a sanitizer report.
// Files that violate this are kept and listed, and the exit status is
// 1. The mutants are created in a new folder inside DIR (default: the folder for temporary files), which is removed if
// there was no fault. --self-test: checks that each of these faults is detected.

#include "FuzzGraphSeeds.h"
#include "FuzzMutation.h"
#include "FuzzResultSeeds.h"
#include "FuzzRunSeeds.h"
#include "FuzzSeeds.h"
#include "FuzzTrial.h"

#include "shapetonCurveSet.h"
#include "shapetonDicomFixture.h"
#include "shapetonDicomSeriesScan.h"
#include "shapetonEmbeddingVerification.h"
#include "shapetonGraphReader.h"
#include "shapetonOperatingSystem.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonVolumeReader.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace
{
namespace fs = std::filesystem;

struct Options
{
  std::size_t   files{ 2000 };
  std::uint64_t seed{ 1 };
  std::string   kind{ "all" };
  std::string   folder;
  std::string   exam;
  bool          isSelfTest{ false };
};

bool
ParseNumber(const char * text, std::uint64_t & number)
{
  char * end = nullptr;
  number = std::strtoull(text, &end, 10);
  return *text >= '0' && *text <= '9' && *end == '\0';
}

bool
Parse(int argc, char * argv[], Options & options)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string  name = argv[i];
    const char * const value = i + 1 < argc ? argv[i + 1] : "";
    std::uint64_t      number = 0;
    if (name == "--self-test")
    {
      options.isSelfTest = true;
      continue;
    }
    ++i;
    if (name == "--files" && ParseNumber(value, number))
    {
      options.files = number;
    }
    else if (name == "--seed" && ParseNumber(value, number))
    {
      options.seed = number;
    }
    else if (name == "--kind" &&
             std::set<std::string>{ "all", "volumes", "graphs", "files", "results", "runs" }.count(value) > 0)
    {
      options.kind = value;
    }
    else if (name == "--exam" && *value != '\0')
    {
      options.exam = value;
    }
    else if (name == "--folder" && *value != '\0')
    {
      options.folder = value;
    }
    else
    {
      return false;
    }
  }
  return (options.kind == "runs") == !options.exam.empty();
}

bool
IsSurface(const std::string & path)
{
  const std::string                  extension = fs::path(path).extension();
  static const std::set<std::string> surfaces{ ".vtp", ".stl", ".obj", ".ply", ".off", ".gltf", ".glb" };
  return surfaces.count(extension) > 0;
}

/** Reads, inspects and repairs a surface; also reads a VTP file as curves. */
bool
ReadAllOfSurface(const std::string & path)
{
  constexpr auto millimeter = shapeton::SurfaceUnit::Millimeter;
  bool           isRead = IsRead([&] {
    const shapeton::SurfaceMesh mesh = shapeton::ReadSurface(path, { {}, -1, millimeter }).mesh;
    shapeton::InspectSurface(mesh);
    shapeton::InspectSurface(shapeton::RepairSurface(mesh));
  });
  isRead |= IsRead([&] { shapeton::ReadRepairedSurface(path, { {}, 0, millimeter }); });
  if (fs::path(path).extension() == ".vtp")
  {
    isRead |= IsRead([&] { shapeton::ReadCurves(path); });
  }
  return isRead;
}

/** Scans and reads a file as the tools do, with all repairs; also adds a DICOM file to valid slices of its series. */
bool
ReadAllOfVolume(const std::string & path, const std::string & soundFolder)
{
  shapeton::VolumeReadOptions options;
  options.resampleGaps = options.deshear = options.dropDuplicates = options.allowSingleSlice = true;
  bool isRead = IsRead([&] { shapeton::ReadVolume(path, options); });
  if (fs::path(path).extension() == ".dcm")
  {
    const std::string folder = path + ".series";
    fs::create_directory(folder);
    fs::create_symlink(path, folder + "/mutant.dcm");
    fs::create_directory_symlink(soundFolder, folder + "/sound");
    isRead |= IsRead([&] { shapeton::ReadVolume(folder, options); });
    fs::remove_all(folder);
  }
  return isRead;
}

bool
IsGraph(const std::string & path)
{
  static const std::set<std::string> graphs{ ".graphml", ".gml", ".dot", ".edges", ".graph",
                                             ".m",       ".gr",  ".col", ".g6",    ".s6" };
  return graphs.count(fs::path(path).extension()) > 0;
}

/** Reads a graph, or reads and verifies a certificate. */
bool
ReadAllOfGraph(const std::string & path)
{
  return IsGraph(path) ? IsRead([&] { shapeton::ReadGraph(path); })
                       : IsRead([&] { shapeton::VerifyEmbedding(shapeton::ReadEmbeddingCertificate(path)); });
}

bool
ReadAll(const std::string &           path,
        const std::string &           soundFolder,
        const shapeton::DicomSource & source,
        const Options &               options)
{
  if (path.find(RunExtension) != std::string::npos)
  {
    return ReadAllOfRun(path, options.exam);
  }
  if (path.find(ResultExtension) != std::string::npos)
  {
    return ReadAllOfResult(path, source);
  }
  if (IsGraph(path) || fs::path(path).extension() == ".json")
  {
    return ReadAllOfGraph(path);
  }
  return IsSurface(path) ? ReadAllOfSurface(path) : ReadAllOfVolume(path, soundFolder);
}

/** Runs several trials in parallel and counts their outcomes. */
class Campaign
{
public:
  explicit Campaign(std::chrono::seconds limit) : m_Limit(limit) {}

  void
  Start(const std::string & path, const FuzzTrial::Reader & reader)
  {
    const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
    while (m_Running.size() >= most)
    {
      this->Collect();
    }
    m_Running.push_back(std::make_unique<FuzzTrial>(path, path + ".log", reader, m_Limit));
  }

  void
  Finish()
  {
    while (!m_Running.empty())
    {
      this->Collect();
    }
  }

  int
  Report(const Options & options) const
  {
    std::cout << m_Read + m_Refused + m_Faults << " files, seed " << options.seed << ": " << m_Read << " read, "
              << m_Refused << " refused, " << m_Faults << " faults\n";
    for (const auto & contained : m_Contained)
    {
      std::cout << "  contained crashes in " << contained.first << ": " << contained.second << "\n";
    }
    return m_Faults > 0 ? 1 : 0;
  }

  std::size_t
  GetFaults() const
  {
    return m_Faults;
  }

  /** Number of files whose sanitizer reports concern a contained process only. */
  std::size_t
  GetContained() const
  {
    std::size_t count = 0;
    for (const auto & contained : m_Contained)
    {
      count += contained.second;
    }
    return count;
  }

private:
  void
  Collect()
  {
    for (auto trial = m_Running.begin(); trial != m_Running.end();)
    {
      if ((*trial)->HasEnded())
      {
        this->Count(**trial);
        trial = m_Running.erase(trial);
      }
      else
      {
        ++trial;
      }
    }
    usleep(2000);
  }

  void
  Count(const FuzzTrial & trial)
  {
    const FuzzOutcome & outcome = trial.GetOutcome();
    m_Read += outcome.kind == FuzzOutcome::Kind::read ? 1 : 0;
    m_Refused += outcome.kind == FuzzOutcome::Kind::refused ? 1 : 0;
    if (outcome.kind == FuzzOutcome::Kind::fault)
    {
      ++m_Faults;
      std::cout << "FAULT " << outcome.reason << "\n  kept: " << trial.GetPath() << "\n" << std::flush;
    }
    if (!outcome.contained.empty())
    {
      ++m_Contained[outcome.contained];
    }
  }

  std::chrono::seconds                  m_Limit;
  std::list<std::unique_ptr<FuzzTrial>> m_Running;
  std::size_t                           m_Read{ 0 };
  std::size_t                           m_Refused{ 0 };
  std::size_t                           m_Faults{ 0 };
  std::map<std::string, std::size_t>    m_Contained;
};

std::vector<FuzzSeed>
SeedsOf(const Options & options, const shapeton::DicomSource & source)
{
  if (options.kind == "runs")
  {
    return MakeRunSeeds(options.exam, options.folder);
  }
  std::vector<FuzzSeed> seeds;
  const bool            areFiles = options.kind == "files";
  const auto            add = [&](const std::string & kind, const auto & make) {
    if (options.kind == "all" || options.kind == kind || (areFiles && kind != "results"))
    {
      for (const FuzzSeed & seed : make())
      {
        if (!areFiles || (seed.extension != ".dcm" && seed.extension != ".json"))
        {
          seeds.push_back(seed);
        }
      }
    }
  };
  add("volumes", [&] { return MakeFuzzSeeds(options.folder); });
  add("graphs", [&] { return MakeGraphSeeds(options.folder); });
  add("results", [&] { return MakeResultSeeds(options.folder, source); });
  return seeds;
}

int
Fuzz(const Options & options)
{
  const std::string            sound = shapeton::MakeFolder(options.folder + "/sound");
  const shapeton::DicomFixture fixture;
  auto                         slices = fixture.MakeSeries();
  slices.erase(slices.begin() + 2); // mutants take this position
  shapeton::SaveDicom(slices, sound);
  const shapeton::DicomSource source = MakeResultSource(shapeton::MakeFolder(options.folder + "/source"));
  const auto                  seeds = SeedsOf(options, source);
  Campaign                    campaign(std::chrono::seconds(120)); // the readers time out earlier
  for (std::size_t i = 0; i < options.files; ++i)
  {
    FuzzRandom        random(options.seed, i);
    const FuzzSeed &  seed = seeds[i % seeds.size()];
    const FuzzSeed &  other = seeds[random.Below(seeds.size())];
    const std::string bytes = Mutate(seed.bytes, other.bytes, random);
    const std::string path =
      options.folder + "/mutant-" + std::to_string(options.seed) + "-" + std::to_string(i) + seed.extension;
    shapeton::WriteText(path, seed.isGzipped ? Gzip(bytes) : bytes);
    campaign.Start(path, [&](const std::string & file) { return ReadAll(file, sound, source, options); });
  }
  campaign.Finish();
  return campaign.Report(options);
}

// ---- self-test: readers with faults that must be detected ----

[[noreturn]] void
Crash()
{
#if defined(__SANITIZE_ADDRESS__)
  volatile std::size_t beyond = 9;
  const auto           block = std::make_unique<char[]>(8);
  static_cast<void>(*const_cast<volatile char *>(&block[beyond])); // ends with a report and exit status 1
#endif
  std::raise(SIGSEGV);
  std::abort();
}

#if defined(__SANITIZE_ADDRESS__)
/** Apparently succeeds; only the sanitizer's report reveals the fault. */
bool
CrashInChild(const std::string &)
{
  const pid_t child = fork();
  if (child == 0)
  {
    Crash();
  }
  waitpid(child, nullptr, 0);
  return true;
}

/** A contained process asks for more memory than its limit. The sanitizer reports this; the trial must count it as
 * contained. */
bool
AskForTooMuchInChild(const std::string &)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const shapeton::MemoryLimit limit;
    limit.Set(std::size_t(64) << 20, 0);
    const std::vector<char> block(std::size_t(256) << 20, 'x');
    _exit(block[block.size() / 2] == 'x' ? 0 : 1);
  }
  waitpid(child, nullptr, 0);
  return true;
}
#endif

int
SelfTest(const Options & options)
{
  std::vector<std::pair<std::string, FuzzTrial::Reader>> faulty = {
    { "crash", [](const std::string &) -> bool { Crash(); } },
    { "abort", [](const std::string &) -> bool { std::abort(); } },
    { "exit", [](const std::string &) -> bool { _exit(0); } },
    { "exception", [](const std::string &) -> bool { throw std::logic_error("not an InputError"); } },
    { "hang",
      [](const std::string &) {
        sleep(600);
        return true;
      } },
    { "memory",
      [](const std::string &) {
        std::vector<char>                                block(std::size_t(1600) << 20, 'x');
        return block[block.size() / 2] == 'x';
      } }
  };
#if defined(__SANITIZE_ADDRESS__)
  faulty.emplace_back("reportOfChild", CrashInChild);
  faulty.emplace_back("reportOfChildAfterMemoryLimit",
                      [](const std::string & path) { return AskForTooMuchInChild(path) && CrashInChild(path); });
#endif
  int missed = 0;
  for (const auto & reader : faulty)
  {
    const std::string path = options.folder + "/" + reader.first;
    shapeton::WriteText(path, "x");
    Campaign campaign(std::chrono::seconds(3));
    campaign.Start(path, reader.second);
    campaign.Finish();
    if (campaign.GetFaults() != 1)
    {
      std::cout << "not detected: " << reader.first << "\n";
      ++missed;
    }
  }
  Campaign sound(std::chrono::seconds(60));
  shapeton::WriteText(options.folder + "/sound", "x");
  sound.Start(options.folder + "/sound", [](const std::string &) { return true; });
#if defined(__SANITIZE_ADDRESS__)
  shapeton::WriteText(options.folder + "/memoryLimit", "x");
  sound.Start(options.folder + "/memoryLimit", AskForTooMuchInChild);
#endif
  const shapeton::DicomSource source = MakeResultSource(shapeton::MakeFolder(options.folder + "/source"));
  const std::string           falseLength = options.folder + "/falseLength" + ResultExtension;
  shapeton::WriteText(falseLength, MakeResultOfFalseLength(options.folder, source));
  sound.Start(falseLength, [&](const std::string & file) { return ReadAllOfResult(file, source); });
  sound.Finish();
  std::cout << faulty.size() - static_cast<std::size_t>(missed) << " of " << faulty.size() << " faults detected\n";
#if defined(__SANITIZE_ADDRESS__)
  constexpr std::size_t contained = 2; // memoryLimit, falseLength
#else
  constexpr std::size_t contained = 0;
#endif
  std::cout << sound.GetContained() << " of " << contained << " reports are contained\n";
  return missed == 0 && sound.GetFaults() == 0 && sound.GetContained() == contained ? 0 : 1;
}
} // namespace

int
main(int argc, char * argv[])
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::cerr << "usage: FuzzInputs --files N --seed S [--kind all|volumes|graphs|files|results|runs] "
                 "[--exam RUN] [--folder DIR]\n";
    return 2;
  }
  try
  {
    const fs::path parent = options.folder.empty() ? fs::temp_directory_path() : fs::path(options.folder);
    fs::create_directories(parent);
    // Use a new folder, because other files in the given folder must not be removed.
    options.folder = (fs::canonical(parent) / ("FuzzInputs-" + std::to_string(getpid()))).string();
    shapeton::MakeFolder(options.folder);
    const int status = options.isSelfTest ? SelfTest(options) : Fuzz(options);
    if (status == 0)
    {
      fs::remove_all(options.folder);
    }
    return status;
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
