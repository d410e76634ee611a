#include "DicomSeriesToImageXML.h"

#include "shapetonCommandLine.h"
#include "shapetonToolVolumes.h"
#include "shapetonVolumeWriter.h"

using namespace shapeton;

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, [](CommandLine & commandLine) {
    const std::string name = RequireVolumeName(commandLine.GetString("outputVolume"));
    const std::string output = commandLine.Output(name);
    commandLine.RecordRun(name + ".run.json");
    commandLine.Progress("Reading", 0.0);
    constexpr bool allowSingleSlice = true;
    const Volume   volume = ReadVolume(commandLine, "inputVolume", allowSingleSlice);
    commandLine.Progress("Writing", 0.7);
    VolumeMetadata metadata = ProvenanceMetadata(commandLine.GetProvenance());
    const auto     ofSeries = DicomMetadata(volume);
    metadata.insert(metadata.end(), ofSeries.begin(), ofSeries.end());
    const auto whole = ToShort(volume.image);
    if (whole)
    {
      WriteVolume(whole.GetPointer(), output, metadata);
    }
    else
    {
      WriteVolume(volume.image.GetPointer(), output, metadata);
    }
    commandLine.Progress("Writing", 1.0);
  });
}
