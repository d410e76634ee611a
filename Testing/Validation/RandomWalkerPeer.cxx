#include "SeedTrial.h"

#include "shapetonCsvTable.h"
#include "shapetonSeedFiles.h"
#include "shapetonTestFolder.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

using namespace shapeton;

namespace
{
/** Runs the script that calls scikit-image; returns false if it is not installed. */
bool
RunScript(const std::string & arguments)
{
  constexpr int     isMissing = 77;
  const std::string command = SHAPETON_RANDOM_WALKER " " + arguments;
  const int         status = std::system(command.c_str());
  if (WIFEXITED(status) && WEXITSTATUS(status) == isMissing)
  {
    return false;
  }
  if (status != 0)
  {
    throw std::runtime_error("failed: " + command);
  }
  return true;
}
} // namespace

std::optional<std::vector<Segmentation>>
SegmentByRandomWalker(const LabeledVolume & volume, const std::vector<SeedImage::Pointer> & seeds)
{
  const basetest::Folder folder;
  const std::string      image = folder / "image.nii";
  const std::string      times = folder / "times";
  WriteVolume(volume.image.GetPointer(), image);
  std::string arguments = "--times " + times + " " + image;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const std::string of = std::to_string(i) + ".nii";
    WriteVolume(seeds[i].GetPointer(), folder / ("seeds" + of));
    arguments += " " + (folder / ("seeds" + of)) + " " + (folder / ("labels" + of));
  }
  if (!RunScript(arguments))
  {
    return std::nullopt;
  }
  std::vector<Segmentation> segmentations(seeds.size());
  std::ifstream             lines(times);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const std::string labels = folder / ("labels" + std::to_string(i) + ".nii");
    segmentations[i].labels = LabelsOfVolume(ReadVolume(labels), labels, volume.image);
    if (!(lines >> segmentations[i].cpuSeconds >> segmentations[i].hasConverged))
    {
      throw std::runtime_error(times + " has no line for each segmentation");
    }
  }
  return segmentations;
}

std::optional<std::vector<LabeledVolume::ImageType::Pointer>>
RandomWalkerProbabilities(const LabeledVolume & volume, const SeedImage * seeds, double beta, double tol)
{
  const basetest::Folder folder;
  const std::string      image = folder / "image.nii";
  WriteVolume(volume.image.GetPointer(), image);
  WriteVolume(seeds, folder / "seeds.nii");
  const std::string options = "--beta " + CsvTable::Number(beta) + " --tol " + CsvTable::Number(tol);
  if (!RunScript(options + " --probabilities " + image + " " + (folder / "seeds.nii") + " " + (folder / "")))
  {
    return std::nullopt;
  }
  std::vector<LabeledVolume::ImageType::Pointer> probabilities;
  for (std::size_t label = 1; label <= volume.names.size(); ++label)
  {
    probabilities.push_back(ReadVolume(folder / ("probability" + std::to_string(label) + ".nii")).image);
  }
  return probabilities;
}
