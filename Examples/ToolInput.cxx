// A tool that reads a surface selected by command-line parameters, and records the provenance of the result.
// Usage: ExampleToolInput SURFACE [--part NAME] [--component N] [--unit file|m|mm|um]
#include "shapetonCommandLine.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonToolSurfaces.h"

#include <iostream>

static const char xml[] = R"(<?xml version="1.0" encoding="utf-8"?>
<executable><category>Examples</category><title>Area</title><description>Prints the area of a surface.</description>
<version>1.0.0</version><license>Apache-2.0</license><contributor>Shapeton</contributor>
<parameters><label>IO</label><description>The surface.</description>
<geometry type="model" fileExtensions=".vtp,.stl,.obj,.ply,.off,.gltf,.glb"><name>surface</name><label>Surface</label>
<description>A triangle surface.</description><channel>input</channel><index>0</index></geometry>
<string><name>part</name><longflag>part</longflag><label>Part</label><description>The part to read.</description>
<default></default></string>
<integer><name>component</name><longflag>component</longflag><label>Component</label>
<description>The component to use; 0 requires that there is only one.</description><default>0</default></integer>
<string-enumeration><name>unit</name><longflag>unit</longflag><label>Unit</label>
<description>Unit of the file.</description>
<default>file</default><element>file</element><element>m</element><element>mm</element><element>um</element>
</string-enumeration>
</parameters></executable>)";

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(xml, argc, argv, [](shapeton::CommandLine & commandLine) {
    const shapeton::Surface surface = shapeton::ReadRepairedSurface(commandLine, "surface");
    std::cout << shapeton::SurfaceArea(surface.mesh.V, surface.mesh.F) << " mm^2\n";
    for (const auto & [name, value] : commandLine.GetProvenance())
    {
      std::cout << name << ": " << value << '\n';
    }
  });
}
