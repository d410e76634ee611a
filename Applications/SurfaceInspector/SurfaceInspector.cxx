#include "SurfaceInspectorXML.h"

#include "shapetonCommandLine.h"
#include "shapetonJson.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonToolSurfaces.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(ToolXML, argc, argv, [](shapeton::CommandLine & commandLine) {
    const std::string              json = commandLine.OutputOf("json");
    const shapeton::Surface        surface = shapeton::ReadSurfaceToInspect(commandLine, "inputSurface");
    const shapeton::SurfaceQuality quality = shapeton::InspectSurface(surface.mesh);
    if (!json.empty())
    {
      shapeton::Json document;
      document["provenance"] = shapeton::ProvenanceToJson(commandLine.GetProvenance());
      document["warnings"] = surface.notes;
      document["surface"] = shapeton::SurfaceQualityToJson(quality);
      shapeton::WriteJson(document, json);
    }
    std::cout << shapeton::FormatSurfaceQuality(quality);
    for (const std::string & note : surface.notes)
    {
      std::cout << "Note: " << note << '\n';
    }
  });
}
