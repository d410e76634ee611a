#include "DicomSeriesInspectorXML.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomSeriesListing.h"
#include "shapetonVolumeReader.h"

#include <iostream>

using namespace shapeton;

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, [](CommandLine & commandLine) {
    const std::string folder = commandLine.GetString("inputFolder");
    const std::string json = commandLine.OutputOf("json");
    const DicomScan   scan = ScanDicom(folder);
    RequireDicomImages(scan);
    if (!json.empty())
    {
      WriteDicomScan(scan, json, CommandLine::InOptions);
    }
    std::cout << FormatDicomScan(scan, CommandLine::InOptions);
  });
}
