#include "shapetonToolVolumes.h"

#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"
#include "shapetonReadOptions.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shapeton
{
Volume
ReadVolume(CommandLine & commandLine, const std::string & parameter, bool allowSingleSlice)
{
  VolumeReadOptions options;
  ReadOptions(commandLine, options);
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

void
WarnUnlessCT(CommandLine & commandLine, const Volume & volume)
{
  if (!volume.modality.empty() && volume.modality != "CT")
  {
    commandLine.Warn("the series is of modality " + volume.modality +
                     ", not CT: its values are interpreted as Hounsfield units");
  }
}

namespace
{
Volume
ReadWhole(CommandLine & commandLine, const std::string & parameter)
{
  VolumeReadOptions options;
  options.allowSingleSlice = true;
  Volume volume = ReadVolume(commandLine.GetString(parameter), options);
  commandLine.AddInput(parameter, volume.identity);
  return volume;
}

/** Rejects a CT used as mask by mistake: all its nonzero voxels would be lumen. */
void
RequireLabels(const Volume & volume, const std::string & path)
{
  const float * const begin = volume.image->GetBufferPointer();
  const float * const end = begin + volume.image->GetLargestPossibleRegion().GetNumberOfPixels();
  const auto odd = std::find_if(begin, end, [](float value) { return value < 0.0F || value != std::floor(value); });
  if (odd != end)
  {
    std::ostringstream text;
    text << path << ": not a mask, because it contains the value " << *odd
         << "; use an image of non-negative integers, 0 outside";
    throw InputError(text.str());
  }
}
} // namespace

itk::Image<unsigned char, 3>::Pointer
ReadMask(CommandLine & commandLine, const std::string & parameter, const itk::ImageBase<3> * image)
{
  return MaskForImage(ReadWhole(commandLine, parameter), commandLine.GetString(parameter), image);
}

itk::Image<unsigned char, 3>::Pointer
ReadLabelMask(CommandLine & commandLine, const std::string & parameter, const itk::ImageBase<3> * image)
{
  const std::string path = commandLine.GetString(parameter);
  const Volume      volume = ReadWhole(commandLine, parameter);
  auto              mask = MaskForImage(volume, path, image);
  RequireLabels(volume, path);
  return mask;
}

itk::Image<unsigned char, 3>::Pointer
ReadDomain(CommandLine & commandLine, const itk::ImageBase<3> * image)
{
  using Mask = itk::Image<unsigned char, 3>;
  if (!commandLine.IsGiven("mask") && !commandLine.IsGiven("barrier"))
  {
    return nullptr;
  }
  const auto   domain = NewImageOn<Mask>(image, true);
  auto * const first = domain->GetBufferPointer();
  auto * const end = first + domain->GetBufferedRegion().GetNumberOfPixels();
  std::fill(first, end, 1);
  const auto keep = [&](const std::string & parameter, bool isInside) {
    if (commandLine.IsGiven(parameter))
    {
      const auto labels = ReadLabelMask(commandLine, parameter, image);
      std::transform(first, end, labels->GetBufferPointer(), first, [=](unsigned char isIn, unsigned char label) {
        return static_cast<unsigned char>(isIn != 0 && (label != 0) == isInside ? 1 : 0);
      });
    }
  };
  keep("mask", true);
  keep("barrier", false);
  if (std::find(first, end, 1) == end)
  {
    throw InputError("--mask and --barrier leave no voxel of the volume");
  }
  return domain;
}

void
RequireIntensityWindow(const CommandLine & commandLine)
{
  std::optional<std::array<double, 2>> window;
  ReadOption(commandLine, OptionInfo("intensityWindow"), window);
}
} // namespace shapeton
