// Regenerates the tables of the validation report; see Utilities/run-validation.
#include "ValidationReport.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>

namespace
{
struct Part
{
  std::string                                                         name;
  std::string                                                         title;
  std::function<void(const ValidationSettings &, ValidationReport &)> run;
  bool                                                                needsData;
  bool                                                                hasQuick{ true };
};

const std::vector<Part> parts = {
  { "heat-accuracy", "Accuracy of the heat", ValidateAccuracyOfHeat, false },
  { "heat-shapes", "Heat of known shapes", ValidateHeatOfShapes, false },
  { "heat-figures", "Figures 2.4, 2.5 and 2.7 of the dissertation", ValidateFiguresOfChapter2, false },
  { "heat-classes", "Classes of phantoms with noise", ValidateClassesOfPhantoms, false },
  { "heat-organs", "Heat classes and organs of a real abdomen", ValidateOrgansOfAbdomen, true },
  { "shape-search", "Shapes found again by their signatures", ValidateSearchOfShapes, false },
  { "seeded-heat", "Labels from seeds, beside peers", ValidateSegmentationFromSeeds, false },
  { "seeded-heat-organs", "All organs from seeds, beside peers", ValidateSegmentationOfOrgans, true, false },
  { "shapeton-comparison", "CHD or shapetons?", ValidateComparisonOfShapetons, false },
  { "shapeton-walk", "Scale and time of shapetons", ValidateWalkOfShapetons, false },
  { "flattening-metric", "Accuracy of the heat diffusion metric", ValidateAccuracyOfMetric, false },
  { "flattening-accuracy", "Accuracy of flat colons", ValidateAccuracyOfFlattening, false },
  { "flattening-distances", "Figure 5.2: geodesic and diffusion distance", ValidateDistancesOfHands, false },
  { "flattening-slits", "Figure 5.3: a face with three holes", ValidateSlitMapsOfFace, false },
  { "flattening-handle", "Figure 5.4: a pot with and without its handle", ValidatePotWithHandle, false },
  { "flattening-colon", "Figure 5.5: a flat colon with handles", ValidateFlatColonWithHandles, false },
  { "flattening-quality", "Eigenpairs and times of the heat diffusion metric", ValidateQualityOfMetric, false },
  { "colon-surfaces", "Surface and centerline of synthetic colons", ValidateColonSurfaces, false },
  { "colon-noise", "Synthetic colons in strong noise", ValidateColonNoise, false, false },
  { "colon-surfaces-fine", "Synthetic colons in fine voxels", ValidateColonSurfacesFine, false, false },
  { "colon-catheters", "Rectal catheters of synthetic patients", ValidateColonCatheters, false, false },
  { "colon-landmarks", "Folds, taeniae and flexures of synthetic colons", ValidateColonLandmarks, false },
  { "colon-landmarks-ct", "Folds, taeniae and flexures from CT", ValidateColonLandmarksFromCt, false, false },
  { "colon-registration", "Supine and prone: one map between two positions", ValidateColonRegistration, false },
  { "colon-registration-ct", "Supine and prone from CT", ValidateColonRegistrationFromCt, false, false },
  { "colon-pairs", "Confidence of pairs of positions", ValidateReliabilityOfPairs, false, false },
  { "colon-polyps", "Polyp candidates of synthetic colons", ValidateColonPolyps, false },
  { "colon-polyps-ct", "Polyp candidates from CT", ValidateColonPolypsFromCt, false, false },
  { "graph-embedding", "Embeddings of graphs", ValidateGraphEmbedding, false },
};

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
  std::string        rows;    ///< for CSV files; empty for the output folder
  std::string        wanted;  ///< empty for all parts
  std::string        options; ///< options that change the content of a page
};

/** Reads the value of an option; returns false if it is invalid. */
using Taker = std::function<bool(const std::string &, Request &)>;

const std::map<std::string, Taker> takers = {
  { "--output",
    [](const std::string & value, Request & request) {
      request.output = value;
      return !value.empty();
    } },
  { "--rows",
    [](const std::string & value, Request & request) {
      request.rows = value;
      return !value.empty();
    } },
  { "--patients",
    [](const std::string & value, Request & request) {
      request.settings.patients = std::atoi(value.c_str());
      return request.settings.patients > 0;
    } },
  { "--firstSeed",
    [](const std::string & value, Request & request) {
      request.settings.firstSeed = static_cast<unsigned int>(std::max(0, std::atoi(value.c_str())));
      return request.settings.firstSeed > 0;
    } },
  { "--draws",
    [](const std::string & value, Request & request) {
      request.settings.draws = std::atoi(value.c_str());
      return request.settings.draws > 0;
    } },
  { "--seedsOfLabel",
    [](const std::string & value, Request & request) {
      request.settings.seedsOfLabel = std::atoi(value.c_str());
      return request.settings.seedsOfLabel > 0;
    } },
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
      request.options += argument == "--output" || argument == "--rows" ? "" : argument + ' ' + arguments[i] + ' ';
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

/** Returns the exit status. */
int
Run(const Request & request)
{
  unsigned int failures = 0;
  unsigned int done = 0;
  for (const Part & part : parts)
  {
    if ((!request.wanted.empty() && request.wanted != part.name) || (request.settings.quick && !part.hasQuick))
    {
      continue;
    }
    ++done;
    if (part.needsData && request.settings.dataFolder.empty())
    {
      std::printf("%-16s skipped: SHAPETON_TEST_DATA_DIR is not set\n", part.name.c_str());
      continue;
    }
    ValidationReport report(part.title);
    report.AddText("Made by `Utilities/run-validation " + request.options + part.name + "`.");
    part.run(request.settings, report);
    report.Write(request.output, request.rows.empty() ? request.output : request.rows, part.name);
    std::printf("%-16s %s\n", part.name.c_str(), report.GetNumberOfFailures() == 0 ? "pass" : "FAIL");
    std::fflush(stdout);
    failures += report.GetNumberOfFailures();
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
                "[--seedsOfLabel N] [--output FOLDER] [--rows FOLDER] "
                "[PART], PART one of " +
                PartNames());
  }
  if (const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR"))
  {
    request.settings.dataFolder = folder;
  }
  request.settings.outputFolder = request.output;
  request.settings.pictureFolder = request.settings.quick ? request.output : request.output + "/../pictures";
  try
  {
    std::filesystem::create_directories(request.output);
    if (!request.rows.empty())
    {
      std::filesystem::create_directories(request.rows);
    }
    std::filesystem::create_directories(request.settings.pictureFolder);
    return Run(request);
  }
  catch (const std::exception & error)
  {
    return Fail(error.what());
  }
}
