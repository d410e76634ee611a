// usage: MeasureColonLumen INPUT [--truth FOLDER] [--position P] [--pictures PREFIX] [--seed x,y,z]
//
// Segments and cleanses a CT and prints the result, with errors if the truth of a phantom is given. INPUT: any input of
// ReadVolume(), or a NumPy file of 16-bit integers (1 mm voxels).

#include "shapetonColonMeasures.h"
#include "shapetonLumenPictures.h"

#include "shapetonVolumeReader.h"

#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <map>

namespace
{
using Clock = std::chrono::steady_clock;

double
SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void
Print(const shapeton::ColonLumen & lumen)
{
  const auto & t = lumen.thresholds;
  std::cout << "gravity " << lumen.gravity << " source " << static_cast<int>(lumen.gravitySource) << " noise "
            << lumen.noise << " smoothing " << lumen.smoothing << " tagged " << lumen.isTagged << "\nthresholds: gas "
            << t.gas << " seed " << t.gasSeed << " boundary " << t.gasBoundary << " tissue " << t.tissue << " fluid "
            << t.fluid << " seed " << t.fluidSeed << " boundary " << t.fluidBoundary << '\n';
  for (const auto & p : lumen.pieces)
  {
    std::cout << "piece gas " << p.gasMl << " fluid " << p.fluidMl << " ml, radius " << p.inscribedRadius << ", "
              << p.meanGasHU << " HU, center " << p.center << '\n';
  }
  std::size_t shown = 0;
  for (const auto & p : lumen.leftOut)
  {
    std::cout << "left out: " << p.what << ", " << p.ml << " ml, radius " << p.inscribedRadius << ", " << p.meanHU
              << " HU, center " << p.center << ": " << p.why << '\n';
    if (++shown == 12)
    {
      break;
    }
  }
  shown = 0;
  for (const auto & l : lumen.levels)
  {
    std::cout << "level " << l.area << " mm2, tilt " << l.tilt << ", below " << l.fluidHU << " HU, "
              << (l.isColon ? "colon" : "other") << ", center " << l.center << '\n';
    if (++shown == 25)
    {
      break;
    }
  }
  for (const auto & w : lumen.warnings)
  {
    std::cout << "warning: " << w << '\n';
  }
  std::cout << "failure: " << lumen.failure << '\n';
}

/** Writes whole slices, or the surroundings of a point (LPS, mm) with --look x,y,z. */
void
Draw(const itk::Image<float, 3> *         image,
     const shapeton::ColonLumen &         lumen,
     const shapeton::CleansedColon &      cleansed,
     std::map<std::string, std::string> & arguments)
{
  std::string                 unused;
  const auto                  truth = arguments.count("--truth")
                                        ? shapeton::ReadColonTestVolume(arguments["--truth"] + "/lumen.nrrd", unused)
                                        : itk::Image<float, 3>::Pointer();
  const shapeton::ColonSlices slices(image, lumen, cleansed, truth);
  const auto                  size = image->GetLargestPossibleRegion().GetSize();
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string prefix = arguments["--pictures"] + "-" + std::string(1, "xyz"[axis]);
    if (arguments.count("--look"))
    {
      double x = 0.0, y = 0.0, z = 0.0;
      std::sscanf(arguments["--look"].c_str(), "%lf,%lf,%lf", &x, &y, &z);
      itk::Point<double, 3> point;
      point[0] = x;
      point[1] = y;
      point[2] = z;
      shapeton::WriteColonPicture(slices.Draw(axis, image->TransformPhysicalPointToIndex(point), 32, 6),
                                  prefix + ".png");
      continue;
    }
    for (const int quarter : { 1, 2, 3 })
    {
      const itk::Index<3> middle{ { static_cast<int>(size[0]) / 2 * (axis == 0 ? quarter : 2) / 2,
                                    static_cast<int>(size[1]) / 2 * (axis == 1 ? quarter : 2) / 2,
                                    static_cast<int>(size[2]) / 2 * (axis == 2 ? quarter : 2) / 2 } };
      shapeton::WriteColonPicture(slices.Draw(axis, middle, 1000, size[0] <= 150 ? 4 : 2),
                                  prefix + std::to_string(quarter) + ".png");
    }
  }
}
} // namespace

int
main(int argc, char * argv[])
try
{
  std::map<std::string, std::string> arguments;
  for (int i = 2; i + 1 < argc; i += 2)
  {
    arguments[argv[i]] = argv[i + 1];
  }
  const std::string           path = argv[1];
  shapeton::ColonLumenOptions options;
  const auto                  image = shapeton::ReadColonTestVolume(path, options.patientPosition);
  if (arguments.count("--position"))
  {
    options.patientPosition = arguments["--position"] == "none" ? "" : arguments["--position"];
  }
  auto       start = Clock::now();
  const auto lumen = shapeton::SegmentColonLumen(image, options);
  std::cout << image->GetLargestPossibleRegion().GetSize() << " segmented in " << SecondsSince(start) << " s\n";
  Print(lumen);
  start = Clock::now();
  const auto cleansed = shapeton::CleanseColon(image, lumen);
  std::cout << "cleansed in " << SecondsSince(start) << " s\n";
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  std::cout << "most memory so far " << usage.ru_maxrss / 1024 << " MiB\n";
  if (arguments.count("--pictures"))
  {
    Draw(image, lumen, cleansed, arguments);
  }
  if (arguments.count("--truth"))
  {
    shapeton::CompareWithTruth(image, lumen, cleansed, arguments["--truth"], std::cout);
  }
  return 0;
}
catch (const std::exception & error)
{
  std::cerr << error.what() << '\n';
  return 1;
}
