#include "shapetonToolVolumes.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"

namespace shapeton
{
Volume
ReadVolume(CommandLine & commandLine, const std::string & parameter, bool allowSingleSlice)
{
  VolumeReadOptions options;
  options.seriesUID = commandLine.GetString("seriesUID");
  options.resampleGaps = commandLine.GetFlag("resampleGaps");
  options.deshear = commandLine.GetFlag("deshear");
  options.dropDuplicates = commandLine.GetFlag("dropDuplicates");
  options.allowSingleSlice = allowSingleSlice;
  Volume volume = ReadVolume(commandLine.GetString(parameter), options);
  commandLine.AddInput(parameter, volume.identity);
  for (const std::string & repair : volume.repairs)
  {
    commandLine.AddProvenance("repair", repair);
  }
  commandLine.Warn(volume.notes);
  return volume;
}

itk::Image<unsigned char, 3>::Pointer
ReadMask(CommandLine & commandLine, const std::string & parameter, const itk::ImageBase<3> * image)
{
  const std::string path = commandLine.GetString(parameter);
  VolumeReadOptions options;
  options.allowSingleSlice = true;
  const Volume volume = ReadVolume(path, options);
  commandLine.AddInput(parameter, volume.identity);
  return MaskForImage(volume, path, image);
}

void
RequireIntensityWindow(const CommandLine & commandLine)
{
  const auto window = commandLine.GetDoubles("intensityWindow");
  RequireParameter(window.empty() || (window.size() == 2 && window[0] < window[1]),
                   "--intensityWindow needs two numbers, the lower one first, for example -160,240");
}
} // namespace shapeton
