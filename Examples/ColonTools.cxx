// A tool that flattens a tube and writes a report on it: relief, curvature, scale, distortion.
// Usage: ExampleColonTools TUBE REPORT
#include "shapetonColonFlatteningReport.h"
#include "shapetonCommandLine.h"
#include "shapetonSurfaceReader.h"

#include <iostream>

static const char xml[] = R"(<?xml version="1.0" encoding="utf-8"?>
<executable><category>Examples</category><title>Flat tube</title><description>Reports the flat map of a tube.</description>
<version>1.0.0</version><license>Apache-2.0</license><contributor>Shapeton</contributor>
<parameters><label>IO</label><description>Tube and report.</description>
<geometry type="model" fileExtensions=".vtp,.stl,.obj,.ply,.off,.gltf,.glb"><name>tube</name><label>Tube</label>
<description>A surface with two boundaries.</description><channel>input</channel><index>0</index></geometry>
<directory><name>report</name><label>Report</label><description>A folder.</description>
<channel>output</channel><index>1</index></directory>
</parameters></executable>)";

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(xml, argc, argv, [](shapeton::CommandLine & commandLine) {
    const std::string folder = commandLine.GetString("report");
    commandLine.MakeFolder(folder);
    const shapeton::Surface tube = shapeton::ReadSurface(commandLine.GetString("tube"));
    commandLine.AddInput("tube", tube.identity);
    shapeton::ColonFlatteningSettings options;
    options.progress = commandLine.PartOfProgress(0.0, 0.8);
    const shapeton::ColonFlattening flattening = shapeton::FlattenColon(tube.mesh, "the tube", options);

    const shapeton::FlatColon              flat(flattening.map.flat);
    shapeton::ColonFlatteningReportContent content;
    content.flattening = &flattening;
    content.parts.flat = &flat;
    content.parts.annotations = shapeton::AnnotationsOfHandles(flattening);
    content.warnings = flattening.warnings;
    content.provenance = commandLine.GetProvenance();
    int files = 0;
    shapeton::WriteColonFlatteningReport(content, folder, [&](const std::string & path) {
      ++files;
      return commandLine.Output(path); // a temporary name; the file is renamed at the end
    });
    std::cout << files << " files; handles: " << content.parts.annotations.size() << '\n';
  });
}
