#include "SurfaceInspectorXML.h"

#include "itkCommandLine.h"
#include "itkSurfaceQuality.h"
#include "itkToolSurfaces.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  return itk::CommandLine::Run(ToolXML, argc, argv, [](itk::CommandLine & commandLine) {
    const std::string         json = commandLine.OutputOf("json");
    const itk::Surface        surface = itk::ReadSurface(commandLine, "inputSurface", false);
    const itk::SurfaceQuality quality = itk::InspectSurface(surface.mesh);
    if (!json.empty())
    {
      itk::Json document;
      document["provenance"] = itk::ProvenanceToJson(commandLine.GetProvenance());
      document["warnings"] = surface.notes;
      document["surface"] = itk::SurfaceQualityToJson(quality);
      itk::WriteJson(document, json);
    }
    std::cout << itk::FormatSurfaceQuality(quality);
    for (const std::string & note : surface.notes)
    {
      std::cout << "Note: " << note << '\n';
    }
  });
}
