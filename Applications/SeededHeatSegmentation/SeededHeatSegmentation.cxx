#include "SeededHeatSegmentationXML.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonCommandLine.h"
#include "shapetonReadOptions.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonLabelFiles.h"
#include "shapetonMappedImage.h"
#include "shapetonSeedFiles.h"
#include "shapetonSeededHeatSegmentationImageFilter.h"
#include "shapetonToolSurfaces.h"
#include "shapetonToolVolumes.h"
#include "shapetonVolumeWriter.h"

#include <iomanip>
#include <set>
#include <sstream>

namespace
{
using namespace shapeton;

using ImageType = itk::Image<float, 3>;
using FilterType = SeededHeatSegmentationImageFilter<ImageType>;

bool
IsMarkups(const std::string & path)
{
  const std::string extension = ".json";
  return path.size() > extension.size() && path.substr(path.size() - extension.size()) == extension;
}

void
CheckUsage(const CommandLine & commandLine)
{
  RequireIntensityWindow(commandLine);
  RequireParameter(!commandLine.GetFlag("autoParameters") || !commandLine.IsGiven("p"),
                   "--autoParameters chooses p; do not combine it with --p");
  const std::string automatic = commandLine.GetString("automaticSeeds");
  RequireParameter(automatic != "off" || !commandLine.IsGiven("classes"),
                   "--classes requires --automaticSeeds lines or components");
  RequireParameter(automatic == "components" || !commandLine.IsGiven("components"),
                   "--components requires --automaticSeeds components");
  RequireParameter(automatic == "off" || !IsMarkups(commandLine.GetString("seeds")),
                   "--automaticSeeds: markups are already seeds; use a map of classes");
  RequireVolumeName(commandLine.GetString("uncertainty"));
}

SeedImage::Pointer
ReadSeeds(CommandLine & commandLine, const ImageType * image)
{
  const std::string path = commandLine.GetString("seeds");
  if (IsMarkups(path))
  {
    return SeedsOfMarkups(ReadMarkups(commandLine, "seeds"), image);
  }
  const Volume volume = ReadVolume(path);
  commandLine.AddInput("seeds", volume.identity);
  const auto        seeds = LabelsOfVolume(volume, path, image);
  const std::string automatic = commandLine.GetString("automaticSeeds");
  if (automatic == "off")
  {
    return seeds;
  }
  ClassSeeds choice;
  choice.classes = commandLine.GetIntegers("classes");
  choice.components = automatic == "components" ? commandLine.GetInteger("components") : 0;
  return SeedsOfClasses(seeds, choice);
}

/** Label 1 in a mask and 2 outside; null if no mask is to be corrected. */
SeedImage::Pointer
ReadLabelsBefore(CommandLine & commandLine, const ImageType * image)
{
  if (!commandLine.IsGiven("refine"))
  {
    return nullptr;
  }
  const auto mask = ReadLabelMask(commandLine, "refine", image);
  return MapVoxels<unsigned short>(mask.GetPointer(), [](unsigned char voxel) { return voxel != 0 ? 1 : 2; });
}

void
Configure(CommandLine & commandLine, FilterType * filter)
{
  ReadOptionsOf(commandLine, filter);
  filter->SetKeepProbabilities(commandLine.IsGiven("probabilities"));
  if (commandLine.GetFlag("autoParameters"))
  {
    filter->SetP(ChooseP(filter->GetVolume(), filter->GetOptions()).p);
    commandLine.AddProvenance("option.p", "automatic");
    commandLine.AddProvenance("chosen.p", CsvTable::Number(filter->GetP()));
  }
}

void
WriteProbabilities(CommandLine & commandLine, const FilterType * filter, const VolumeMetadata & metadata)
{
  const std::string     folder = commandLine.MakeFolderOf("probabilities");
  std::set<std::string> names;
  for (const unsigned short label : filter->GetLabelValues())
  {
    std::ostringstream name;
    name << "probability-" << std::setw(5) << std::setfill('0') << label << ".nrrd";
    names.insert(name.str());
    WriteVolume(filter->GetProbabilities(label).GetPointer(), commandLine.Output(folder + '/' + name.str()), metadata);
  }
  CommandLine::RequireNoOthers(folder, "probability-", names);
}

void
LabelVoxels(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const SegmentFiles files(commandLine, "outputLabels");

  const Volume volume = ReadVolume(commandLine, "inputVolume");
  auto         filter = FilterType::New();
  filter->SetInput(volume.image);
  filter->SetDomain(ReadDomain(commandLine, volume.image));
  filter->SetSeeds(ReadSeeds(commandLine, volume.image));
  filter->SetLabelsBefore(ReadLabelsBefore(commandLine, volume.image));
  Configure(commandLine, filter);
  commandLine.Watch(filter, "Diffusing heat from the seeds", 0.0, 0.95);
  filter->Update();
  commandLine.Warn(filter->GetRemarks());
  std::vector<Segment> segments;
  if (commandLine.GetString("automaticSeeds") != "components")
  {
    segments = SegmentsOfFile(commandLine.GetString("seeds"));
  }
  files.WriteSeeded(filter->GetOutput(), filter->GetLabelValues(), segments);
  const auto metadata = ProvenanceMetadata(commandLine.GetProvenance());
  if (commandLine.IsGiven("uncertainty"))
  {
    WriteVolume(filter->GetUncertaintyOutput(), commandLine.OutputOf("uncertainty"), metadata);
  }
  if (commandLine.IsGiven("probabilities"))
  {
    WriteProbabilities(commandLine, filter, metadata);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, LabelVoxels);
}
