#include "SurfaceInspectorXML.h"

#include "shapetonCommandLine.h"
#include "shapetonJson.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonToolSurfaces.h"

#include <iostream>

using namespace shapeton;

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, [](CommandLine & commandLine) {
    const std::string    json = commandLine.OutputOf("json");
    const Surface        surface = ReadSurfaceToInspect(commandLine, "inputSurface");
    const SurfaceQuality quality = InspectSurface(surface.mesh);
    if (!json.empty())
    {
      Json document;
      document["provenance"] = ProvenanceToJson(commandLine.GetProvenance());
      document["warnings"] = surface.notes;
      document["surface"] = SurfaceQualityToJson(quality);
      WriteJson(document, json);
    }
    std::cout << FormatSurfaceQuality(quality);
    for (const std::string & note : surface.notes)
    {
      std::cout << "Note: " << note << '\n';
    }
  });
}
