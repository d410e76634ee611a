#include "shapetonColonTruthWriter.h"

#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonPointPairs.h"
#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonVolumeWriter.h"

namespace shapeton
{
namespace
{
// At most 0.7 of the thinnest septum of the preset, mm.
double
WallEdge(const ColonPhantomParameters & parameters)
{
  return parameters.preset == "hard" ? 0.55 : 0.7;
}

CsvTable
PolypTable(const ColonFluid & fluid, const ColonAnatomy & anatomy)
{
  CsvTable   table({ "id",
                     "kind",
                     "diameter",
                     "height",
                     "x",
                     "y",
                     "z",
                     "baseX",
                     "baseY",
                     "baseZ",
                     "arcLength",
                     "segment",
                     "onFold",
                     "submerged",
                     "materialId" });
  const auto number = [](double value) { return CsvTable::Number(value); };
  for (const auto & polyp : anatomy.Polyps())
  {
    const auto & p = polyp.position;
    const auto & b = polyp.base;
    const bool   submerged = fluid.DepthBelowLevel(p, polyp.arcLength) > 0.0;
    table.AddRow({ std::to_string(polyp.id),
                   polyp.kind,
                   number(polyp.diameter),
                   number(polyp.height),
                   number(p[0]),
                   number(p[1]),
                   number(p[2]),
                   number(b[0]),
                   number(b[1]),
                   number(b[2]),
                   number(polyp.arcLength),
                   std::to_string(polyp.segment),
                   polyp.onFold ? "1" : "0",
                   submerged ? "1" : "0",
                   std::to_string(polyp.materialId) });
  }
  return table;
}
} // namespace

void
WriteColonTruth(CommandLine &             commandLine,
                ColonPhantomImageSource & source,
                const std::string &       folder,
                const CurveSet *          other)
{
  commandLine.MakeFolder(folder);
  const auto file = [&](const char * name) { return commandLine.Output(folder + '/' + name); };
  const auto facts = ProvenanceMetadata(commandLine.GetProvenance());
  WriteVolume(source.GetLumenOutput(), file("lumen.nrrd"), facts);
  WriteVolume(source.GetSegmentOutput(), file("segments.nrrd"), facts);

  const ColonAnatomy & anatomy = source.GetAnatomy();
  const auto           write = [&](CurveSet curves, const char * name) {
    curves.facts.insert(curves.facts.end(), facts.begin(), facts.end());
    WriteCurves(curves, file(name));
  };
  write(anatomy.Centreline(), "centreline.vtp");
  write(anatomy.Folds(), "folds.vtp");
  write(anatomy.Taeniae(), "taeniae.vtp");
  const CurveSet correspondence = anatomy.Correspondence();
  write(correspondence, "correspondence.vtp");
  if (other)
  {
    TableOfPointPairs(*other, correspondence).Write(file("points.csv"));
  }
  SurfaceMesh wall = anatomy.Wall(WallEdge(anatomy.GetParameters()));
  wall.facts.insert(wall.facts.end(), facts.begin(), facts.end());
  WriteSurface(wall, file("wall.vtp"));
  PolypTable(source.GetFluid(), anatomy).Write(file("polyps.csv"));
}
} // namespace shapeton
