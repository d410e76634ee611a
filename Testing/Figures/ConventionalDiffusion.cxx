// Writes the heat of conventional diffusion: of each voxel, what remains of the heat 1 that starts in it alone.
// usage: ConventionalDiffusion INPUT.nrrd OUTPUT.nrrd P STEPS
#include "ConventionalHeat.h"

#include "shapetonExceptions.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>
#include <iostream>

using namespace shapeton;

namespace
{
void
Diffuse(const std::vector<std::string> & arguments)
{
  const Volume          volume = ReadVolume(arguments[0]);
  VolumeGradientOptions options;
  options.p = std::stod(arguments[2]);
  const VolumeGradientOperator volumeGradient(VolumeView(volume.image.GetPointer()), options);
  const std::vector<float>     heat = ConventionalHeat(volumeGradient, std::stoull(arguments[3]));
  std::copy(heat.begin(), heat.end(), volume.image->GetBufferPointer());
  WriteVolume(volume.image.GetPointer(), arguments[1]);
}
} // namespace

int
main(int argc, char * argv[])
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments.back() == "--quiet") // as for the tools
  {
    arguments.pop_back();
  }
  if (arguments.size() != 4)
  {
    std::cerr << "usage: ConventionalDiffusion INPUT.nrrd OUTPUT.nrrd P STEPS\n";
    return 2;
  }
  try
  {
    Diffuse(arguments);
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return EXIT_SUCCESS;
}
