#include "DicomSeriesInspectorXML.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomSeriesListing.h"
#include "shapetonVolumeReader.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(ToolXML, argc, argv, [](shapeton::CommandLine & commandLine) {
    const std::string         folder = commandLine.GetString("inputFolder");
    const std::string         json = commandLine.OutputOf("json");
    const shapeton::DicomScan scan = shapeton::ScanDicom(folder);
    shapeton::RequireDicomImages(scan);
    if (!json.empty())
    {
      shapeton::WriteDicomScan(scan, json, shapeton::CommandLine::InOptions);
    }
    std::cout << shapeton::FormatDicomScan(scan, shapeton::CommandLine::InOptions);
  });
}
