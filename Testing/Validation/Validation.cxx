// Regenerates the tables of the validation report; see Utilities/run-validation.
#include "ValidationReport.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>

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
  { "shapeton-comparison", "CHD or shapetons?", ValidateComparisonOfShapetons, false },
  { "shapeton-walk", "Scale and time of shapetons", ValidateWalkOfShapetons, false },
  { "flattening-metric", "Accuracy of the heat diffusion metric", ValidateAccuracyOfMetric, false },
  { "flattening-accuracy", "Accuracy of flat colons", ValidateAccuracyOfFlattening, false },
  { "flattening-distances", "Figure 5.2: geodesic and diffusion distance", ValidateDistancesOfHands, false },
  { "flattening-slits", "Figure 5.3: a face with three holes", ValidateSlitMapsOfFace, false },
  { "flattening-handle", "Figure 5.4: a pot with and without its handle", ValidatePotWithHandle, false },
  { "flattening-colon", "Figure 5.5: a flat colon with handles", ValidateFlatColonWithHandles, false },
  { "flattening-quality", "Eigenpairs and times of the heat diffusion metric", ValidateQualityOfMetric, false },
  { "colon-surfaces", "Surface and centreline of synthetic colons", ValidateColonSurfaces, false },
  { "colon-noise", "Synthetic colons in strong noise", ValidateColonNoise, false, false },
  { "colon-surfaces-fine", "Synthetic colons in fine voxels", ValidateColonSurfacesFine, false, false },
  { "colon-landmarks", "Folds, taeniae and flexures of synthetic colons", ValidateColonLandmarks, false },
  { "colon-landmarks-ct", "Folds, taeniae and flexures from CT", ValidateColonLandmarksFromCt, false, false },
  { "colon-registration", "Supine and prone: one map between two positions", ValidateColonRegistration, false },
  { "colon-registration-ct", "Supine and prone from CT", ValidateColonRegistrationFromCt, false, false },
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
} // namespace

int
main(int argc, char * argv[])
{
  ValidationSettings settings;
  std::string        output = ".";
  std::string        wanted;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--quick")
    {
      settings.quick = true;
    }
    else if (argument == "--output" && i + 1 < argc)
    {
      output = argv[++i];
    }
    else if (argument == "--patients" && i + 1 < argc && std::atoi(argv[i + 1]) > 0)
    {
      settings.patients = std::atoi(argv[++i]);
    }
    else if (argument == "--firstSeed" && i + 1 < argc && std::atoi(argv[i + 1]) > 0)
    {
      settings.firstSeed = static_cast<unsigned int>(std::atoi(argv[++i]));
    }
    else if (argument.empty() || argument[0] == '-' || !wanted.empty())
    {
      return Fail("usage: Validation [--quick] [--patients N] [--firstSeed N] [--output FOLDER] [PART], PART one of " +
                  PartNames());
    }
    else
    {
      wanted = argument;
    }
  }
  if (const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR"))
  {
    settings.dataFolder = folder;
  }
  std::filesystem::create_directories(output);
  settings.pictureFolder = settings.quick ? output : output + "/../pictures";
  std::filesystem::create_directories(settings.pictureFolder);
  settings.outputFolder = output;
  unsigned int failures = 0;
  unsigned int done = 0;
  for (const Part & part : parts)
  {
    if ((!wanted.empty() && wanted != part.name) || (settings.quick && !part.hasQuick))
    {
      continue;
    }
    if (part.needsData && settings.dataFolder.empty())
    {
      std::printf("%-16s skipped: SHAPETON_TEST_DATA_DIR is not set\n", part.name.c_str());
      ++done;
      continue;
    }
    ValidationReport report(part.title);
    report.AddText(std::string("Made by `Utilities/run-validation ") + (settings.quick ? "--quick " : "") + part.name +
                   "`.");
    part.run(settings, report);
    report.Write(output + '/' + part.name + ".md");
    std::printf("%-16s %s\n", part.name.c_str(), report.GetNumberOfFailures() == 0 ? "pass" : "FAIL");
    std::fflush(stdout);
    failures += report.GetNumberOfFailures();
    ++done;
  }
  if (done == 0)
  {
    return Fail("no part \"" + wanted + "\"; the parts are " + PartNames());
  }
  return failures == 0 ? 0 : 1;
}
