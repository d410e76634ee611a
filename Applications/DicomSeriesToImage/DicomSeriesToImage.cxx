#include "DicomSeriesToImageXML.h"

#include "shapetonCommandLine.h"
#include "shapetonToolVolumes.h"
#include "shapetonVolumeWriter.h"

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(ToolXML, argc, argv, [](shapeton::CommandLine & commandLine) {
    const std::string name = shapeton::RequireVolumeName(commandLine.GetString("outputVolume"));
    const std::string output = commandLine.Output(name);
    commandLine.RecordRun(name + ".run.json");
    commandLine.Progress("Reading", 0.0);
    constexpr bool         allowSingleSlice = true;
    const shapeton::Volume volume = shapeton::ReadVolume(commandLine, "inputVolume", allowSingleSlice);
    commandLine.Progress("Writing", 0.7);
    const auto whole = shapeton::ToShort(volume.image);
    if (whole)
    {
      shapeton::WriteVolume(whole.GetPointer(), output, shapeton::ProvenanceMetadata(commandLine.GetProvenance()));
    }
    else
    {
      shapeton::WriteVolume(
        volume.image.GetPointer(), output, shapeton::ProvenanceMetadata(commandLine.GetProvenance()));
    }
    commandLine.Progress("Writing", 1.0);
  });
}
