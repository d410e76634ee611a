#include "DicomSeriesInspectorXML.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomSeriesListing.h"
#include "shapetonExceptions.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(ToolXML, argc, argv, [](shapeton::CommandLine & commandLine) {
    const std::string         folder = commandLine.GetString("inputFolder");
    const std::string         json = commandLine.OutputOf("json");
    const shapeton::DicomScan scan = shapeton::ScanDicom(folder);
    if (scan.series.empty())
    {
      throw shapeton::InputError(folder + ": notAnImage: none of its " + std::to_string(scan.files) +
                                 " files is a DICOM image (" + scan.otherFiles.front().message +
                                 "); name the folder that holds the series");
    }
    if (!json.empty())
    {
      shapeton::WriteDicomScan(scan, json, shapeton::CommandLine::InOptions);
    }
    std::cout << shapeton::FormatDicomScan(scan, shapeton::CommandLine::InOptions);
  });
}
