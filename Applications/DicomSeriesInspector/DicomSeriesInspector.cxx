#include "DicomSeriesInspectorXML.h"

#include "itkCommandLine.h"
#include "itkDicomSeriesListing.h"
#include "itkExceptions.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  return itk::CommandLine::Run(ToolXML, argc, argv, [](itk::CommandLine & commandLine) {
    const std::string    folder = commandLine.GetString("inputFolder");
    const std::string    json = commandLine.OutputOf("json");
    const itk::DicomScan scan = itk::ScanDicom(folder);
    if (scan.series.empty())
    {
      throw itk::InputError(folder + ": notAnImage: none of its " + std::to_string(scan.files) +
                            " files is a DICOM image (" + scan.otherFiles.front().message +
                            "); name the folder that holds the series");
    }
    if (!json.empty())
    {
      itk::WriteDicomScan(scan, json, itk::CommandLine::InOptions);
    }
    std::cout << itk::FormatDicomScan(scan, itk::CommandLine::InOptions);
  });
}
