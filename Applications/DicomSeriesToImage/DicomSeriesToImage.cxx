#include "DicomSeriesToImageXML.h"

#include "itkCommandLine.h"
#include "itkToolVolumes.h"
#include "itkVolumeWriter.h"

int
main(int argc, char * argv[])
{
  return itk::CommandLine::Run(ToolXML, argc, argv, [](itk::CommandLine & commandLine) {
    const std::string name = itk::RequireVolumeName(commandLine.GetString("outputVolume"));
    const std::string output = commandLine.Output(name);
    commandLine.RecordRun(name + ".run.json");
    commandLine.Progress("Reading", 0.0);
    constexpr bool    allowSingleSlice = true;
    const itk::Volume volume = itk::ReadVolume(commandLine, "inputVolume", allowSingleSlice);
    commandLine.Progress("Writing", 0.7);
    const auto whole = itk::ToShort(volume.image);
    if (whole)
    {
      itk::WriteVolume(whole.GetPointer(), output, itk::ProvenanceMetadata(commandLine.GetProvenance()));
    }
    else
    {
      itk::WriteVolume(volume.image.GetPointer(), output, itk::ProvenanceMetadata(commandLine.GetProvenance()));
    }
    commandLine.Progress("Writing", 1.0);
  });
}
