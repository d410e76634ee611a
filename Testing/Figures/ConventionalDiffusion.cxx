// Writes the heat of conventional diffusion: of each voxel, what remains of the heat 1 that starts in it alone.
// usage: ConventionalDiffusion INPUT.nrrd OUTPUT.nrrd P STEPS
#include "ConventionalHeat.h"
#include "FigureProgram.h"

#include "shapetonExceptions.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>

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
  return RunFigureProgram(
    argc, argv, { 4, 4 }, "INPUT.nrrd OUTPUT.nrrd P STEPS", [](const std::vector<std::string> & arguments) {
      Diffuse(arguments);
    });
}
