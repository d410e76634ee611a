// A command-line tool: the XML declares its options and provides --help, checks, exit status and 3D Slicer's panel.
// Usage: ExampleCommandLine --radius 10
#include "shapetonCommandLine.h"

#include <cmath>
#include <iostream>

static const char xml[] = R"(<?xml version="1.0" encoding="utf-8"?>
<executable><category>Examples</category><title>Ball</title><description>Prints the volume of a ball.</description>
<version>1.0.0</version><license>Apache-2.0</license><contributor>Shapeton</contributor>
<parameters><label>Ball</label><description>Its size.</description>
<double><name>radius</name><longflag>radius</longflag><label>Radius</label><description>Radius in mm.</description>
<default>1</default><constraints><minimum>0</minimum></constraints></double>
</parameters></executable>)";

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(xml, argc, argv, [](shapeton::CommandLine & commandLine) {
    const double radius = commandLine.GetDouble("radius");
    std::cout << 4.0 / 3.0 * std::acos(-1.0) * std::pow(radius, 3) << " mm^3\n";
  });
}
