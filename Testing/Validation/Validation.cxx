// Regenerates the tables of the validation report; see Utilities/run-validation.
#include "ValidationReport.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>

namespace
{
/** A page of the report, shared by the parts of an area. */
struct Area
{
  std::string name;
  std::string title;
  bool        hasPatients{ false }; ///< parts depend on the first seed of the synthetic patients
};

const std::vector<Area> areas = {
  { "heat", "Validation of cumulative heat diffusion" },
  { "shapetons", "Validation of shapetons" },
  { "shape-search", "Validation of shape search" },
  { "seeded-heat", "Validation of labels from seeds" },
  { "flattening", "Validation of flattening", true },
  { "colon-surfaces", "Validation of colon surfaces and centerlines", true },
  { "colon-landmarks", "Validation of colon landmarks", true },
  { "colon-registration", "Validation of supine and prone registration", true },
  { "colon-polyps", "Validation of polyp candidates", true },
  { "published-results", "Beside published results" },
  { "graph-embedding", "Validation of graph embeddings" },
};

/** Properties of parts. */
constexpr unsigned int needsData = 1;
constexpr unsigned int isLong = 2; ///< left out with --quick

struct Part
{
  std::string                     area;
  std::string                     name;
  std::string                     title;
  std::function<ValidationOfPart> run;
  unsigned int                    properties{ 0 };
};

const std::vector<Part> parts = {
  { "heat", "heat-accuracy", "Accuracy of the heat", ValidateAccuracyOfHeat },
  { "heat", "heat-shapes", "Heat of known shapes", ValidateHeatOfShapes },
  { "heat", "heat-figures", "Figures 2.4, 2.5 and 2.7 of the dissertation", ValidateFiguresOfChapter2 },
  { "heat", "heat-classes", "Classes of phantoms with noise", ValidateClassesOfPhantoms },
  { "heat", "heat-organs", "Heat classes and organs of a real abdomen", ValidateOrgansOfAbdomen, needsData },
  { "heat", "heat-objects", "Objects from heat", ValidateObjectsOfVolumes },
  { "shape-search", "shape-search", "Shape retrieval by signature", ValidateSearchOfShapes },
  { "seeded-heat", "seeded-heat", "Labels from seeds compared with other methods", ValidateSegmentationFromSeeds },
  { "seeded-heat",
    "seeded-heat-organs",
    "All organs from seeds compared with other methods",
    ValidateSegmentationOfOrgans,
    needsData | isLong },
  { "shapetons", "shapeton-comparison", "CHD or shapetons?", ValidateComparisonOfShapetons },
  { "shapetons", "shapeton-objects", "Objects by shapetons", ValidateObjectsByShapetons },
  { "shapetons", "shapeton-walk", "Scale and time of shapetons", ValidateWalkOfShapetons },
  { "flattening", "flattening-metric", "Accuracy of the heat diffusion metric", ValidateAccuracyOfMetric },
  { "flattening", "flattening-accuracy", "Accuracy of flat colons", ValidateAccuracyOfFlattening },
  { "flattening", "flattening-distances", "Figure 5.2: geodesic and diffusion distance", ValidateDistancesOfHands },
  { "flattening", "flattening-slits", "Figure 5.3: a face with three holes", ValidateSlitMapsOfFace },
  { "flattening", "flattening-handle", "Figure 5.4: a pot with and without its handle", ValidatePotWithHandle },
  { "flattening", "flattening-colon", "Figure 5.5: a flat colon with handles", ValidateFlatColonWithHandles },
  { "flattening", "flattening-quality", "Eigenpairs and times of the heat diffusion metric", ValidateQualityOfMetric },
  { "flattening", "flattening-topology", "Walls with and without their handles", ValidateTopologyOfWalls, isLong },
  { "colon-surfaces", "colon-surfaces", "Surface and centerline of synthetic colons", ValidateColonSurfaces },
  { "colon-surfaces", "colon-noise", "Synthetic colons in strong noise", ValidateColonNoise, isLong },
  { "colon-surfaces", "colon-surfaces-fine", "Synthetic colons in fine voxels", ValidateColonSurfacesFine, isLong },
  { "colon-surfaces", "colon-catheters", "Rectal catheters of synthetic patients", ValidateColonCatheters, isLong },
  { "colon-landmarks", "colon-landmarks", "Folds, taeniae and flexures of synthetic colons", ValidateColonLandmarks },
  { "colon-landmarks",
    "colon-landmarks-ct",
    "Folds, taeniae and flexures from CT",
    ValidateColonLandmarksFromCt,
    isLong },
  { "colon-registration",
    "colon-registration",
    "Supine and prone: one map between two positions",
    ValidateColonRegistration },
  { "colon-registration",
    "colon-registration-ct",
    "Supine and prone from CT",
    ValidateColonRegistrationFromCt,
    isLong },
  { "colon-registration", "colon-pairs", "Confidence of pairs of positions", ValidateReliabilityOfPairs, isLong },
  { "colon-registration", "colon-taeniae", "Numbers and names of taeniae", ValidateTaeniae, isLong },
  { "colon-polyps", "colon-polyps", "Polyp candidates of synthetic colons", ValidateColonPolyps },
  { "colon-polyps", "colon-polyps-ct", "Polyp candidates from CT", ValidateColonPolypsFromCt, isLong },
  { "colon-polyps", "colon-polyps-published", "Polyp candidates by shapetons", ValidatePublishedPolyps, isLong },
  { "published-results", "published-results", "Colon tools beside published results", ValidatePublishedResults },
  { "graph-embedding", "graph-embedding", "Embeddings of graphs", ValidateGraphEmbedding },
};

const Area &
AreaOf(const Part & part)
{
  const auto area = std::find_if(areas.begin(), areas.end(), [&part](const Area & a) { return a.name == part.area; });
  if (area == areas.end())
  {
    throw std::logic_error("No area \"" + part.area + "\" for the part " + part.name + '.');
  }
  return *area;
}

int
Fail(const std::string & message)
{
  std::fprintf(stderr, "Validation: %s\n", message.c_str());
  return 2;
}

std::string
PartNames()
{
  std::string names;
  for (const Part & part : parts)
  {
    names += (names.empty() ? "" : ", ") + part.name;
  }
  return names;
}

/** Command line options. */
struct Request
{
  ValidationSettings settings;
  std::string        output{ "." };
  std::string        results; ///< for pictures, and for CSV files in its folder tables; empty for the output folder
  std::string        wanted;  ///< empty for all parts
  std::string        options; ///< options that affect the content of a section
};

/** Reads the value of an option; returns false if it is invalid. */
using Taker = std::function<bool(const std::string &, Request &)>;

template <typename TNumber>
Taker
NumberAbove0(TNumber ValidationSettings::*number)
{
  return [number](const std::string & value, Request & request) {
    request.settings.*number = static_cast<TNumber>(std::max(0, std::atoi(value.c_str())));
    return request.settings.*number > 0;
  };
}

const std::map<std::string, Taker> takers = {
  { "--output",
    [](const std::string & value, Request & request) {
      request.output = value;
      return !value.empty();
    } },
  { "--results",
    [](const std::string & value, Request & request) {
      request.results = value;
      return !value.empty();
    } },
  { "--patients", NumberAbove0(&ValidationSettings::patients) },
  { "--firstSeed", NumberAbove0(&ValidationSettings::firstSeed) },
  { "--draws", NumberAbove0(&ValidationSettings::draws) },
  { "--seedsOfLabel", NumberAbove0(&ValidationSettings::seedsOfLabel) },
  { "--preset",
    [](const std::string & value, Request & request) {
      request.settings.presets.assign(1, value);
      return !value.empty();
    } },
};

/** Returns false if an argument is invalid. */
bool
Parse(const std::vector<std::string> & arguments, Request & request)
{
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string & argument = arguments[i];
    const auto          taker = takers.find(argument);
    if (taker != takers.end())
    {
      if (i + 1 == arguments.size() || !taker->second(arguments[i + 1], request))
      {
        return false;
      }
      ++i;
      request.options += argument == "--output" || argument == "--results" ? "" : argument + ' ' + arguments[i] + ' ';
    }
    else if (argument == "--quick")
    {
      request.settings.quick = true;
      request.options += argument + ' ';
    }
    else if (argument.empty() || argument[0] == '-' || !request.wanted.empty())
    {
      return false;
    }
    else
    {
      request.wanted = argument;
    }
  }
  return true;
}

/** Runs a part and writes its section and its rows; returns the number of failures. Patients with another first seed
 * have a separate section and rows. */
unsigned int
RunPart(const Part & part, const Request & request)
{
  const Area &      area = AreaOf(part);
  const std::string seed =
    area.hasPatients && request.settings.firstSeed > 0 ? std::to_string(request.settings.firstSeed) : "";
  ValidationSection section;
  section.page = request.output + '/' + area.name + ".md";
  section.pageTitle = area.title;
  section.name = part.name + (seed.empty() ? "" : " --firstSeed " + seed);
  section.pictureFolder = request.settings.outputFolder;
  section.rowsFolder = request.settings.rowsFolder;
  section.rowsPrefix = (seed.empty() ? "" : "seeds-" + seed + '-') + part.name;

  ValidationReport report(part.title + (seed.empty() ? "" : ", seeds from " + seed));
  report.AddText("Made by `Utilities/run-validation " + request.options + part.name + "`.");
  part.run(request.settings, report);
  report.Write(section);
  return report.GetNumberOfFailures();
}

/** Returns the exit status. */
int
Run(const Request & request)
{
  unsigned int failures = 0;
  unsigned int done = 0;
  for (const Part & part : parts)
  {
    if ((!request.wanted.empty() && request.wanted != part.name) ||
        (request.settings.quick && (part.properties & isLong) != 0))
    {
      continue;
    }
    ++done;
    if ((part.properties & needsData) != 0 && request.settings.dataFolder.empty())
    {
      std::printf("%-16s skipped: SHAPETON_TEST_DATA_DIR is not set\n", part.name.c_str());
      continue;
    }
    const unsigned int failed = RunPart(part, request);
    std::printf("%-16s %s\n", part.name.c_str(), failed == 0 ? "pass" : "FAIL");
    std::fflush(stdout);
    failures += failed;
  }
  if (done == 0)
  {
    return Fail("no part \"" + request.wanted + "\"; the parts are " + PartNames());
  }
  return failures == 0 ? 0 : 1;
}
} // namespace

int
main(int argc, char * argv[])
{
  Request request;
  if (!Parse({ argv + 1, argv + argc }, request))
  {
    return Fail("usage: Validation [--quick] [--patients N] [--firstSeed N] [--preset NAME] [--draws N] "
                "[--seedsOfLabel N] [--output FOLDER] [--results FOLDER] [PART], PART one of " +
                PartNames());
  }
  if (const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR"))
  {
    request.settings.dataFolder = folder;
  }
  ValidationSettings & settings = request.settings;
  settings.outputFolder = request.results.empty() ? request.output : request.results;
  settings.rowsFolder = settings.outputFolder + "/tables";
  settings.pictureFolder = settings.quick ? settings.outputFolder : settings.outputFolder + "/../pictures";
  try
  {
    std::filesystem::create_directories(request.output);
    std::filesystem::create_directories(settings.rowsFolder);
    std::filesystem::create_directories(settings.pictureFolder);
    return Run(request);
  }
  catch (const std::exception & error)
  {
    return Fail(error.what());
  }
}
