#include "shapetonColonTruthWriter.h"

#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonPointPairs.h"
#include "shapetonCsvTable.h"
#include "shapetonJson.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonVolumeWriter.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
namespace
{
/** Maximum edge length: 0.7 of the thinnest septum of the preset, mm. */
double
WallEdge(const ColonPhantomParameters & parameters)
{
  constexpr double ofHard = 0.55;
  constexpr double ofOthers = 0.7;
  return parameters.preset == "hard" ? ofHard : ofOthers;
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

Json
ToJson(const Eigen::Vector3d & v)
{
  return { RoundedJson(v[0]), RoundedJson(v[1]), RoundedJson(v[2]) };
}

Json
ValveToJson(const ColonAnatomy & anatomy)
{
  const ColonValve valve = anatomy.Valve();
  Json             json = { { "kind", valve.kind },
                            { "position", ToJson(valve.position) },
                            { "base", ToJson(valve.base) },
                            { "mouth", ToJson(valve.mouth) },
                            { "direction", ToJson(valve.direction) },
                            { "slit", ToJson(valve.slit) },
                            { "length", RoundedJson(valve.length) },
                            { "height", RoundedJson(valve.height) },
                            { "lipThickness", RoundedJson(valve.thickness) },
                            { "arcLength", RoundedJson(valve.arcLength) } };
  if (valve.kind == "lips")
  {
    json["upperLip"] = ToJson(valve.upperLip);
    json["lowerLip"] = ToJson(valve.lowerLip);
    json["fat"] = RoundedJson(anatomy.GetParameters().valveFat);
  }
  return json;
}

Json
IleumToJson(const ColonIleum & ileum)
{
  return { { "content", ileum.content },
           { "open", ileum.isOpen },
           { "slitWidth", RoundedJson(ileum.slitWidth) },
           { "bore", RoundedJson(ileum.bore) },
           { "length", RoundedJson(ileum.length) },
           { "volume", RoundedJson(ileum.volume) }, // ml
           { "refluxed", ileum.isRefluxed },
           { "intensity", RoundedJson(ileum.intensity) } };
}

Json
ContactToJson(const ColonContact & contact)
{
  return { { "arcLength", { RoundedJson(contact.arcLength[0]), RoundedJson(contact.arcLength[1]) } },
           { "bore", RoundedJson(contact.bore) },
           { "length", RoundedJson(contact.length) },
           { "intensity", RoundedJson(contact.intensity) } };
}

Json
CatheterToJson(const ColonCatheter & catheter)
{
  Json json = { { "kind", catheter.kind },
                { "bore", RoundedJson(catheter.bore) },
                { "wall", RoundedJson(catheter.wall) },
                { "intensity", RoundedJson(catheter.intensity) },
                { "sideHoles", catheter.sideHoles },
                { "tip", ToJson(catheter.tip) },
                { "balloon", catheter.balloon } };
  if (catheter.balloon != "none")
  {
    json["balloonCenter"] = ToJson(catheter.balloonCenter);
    json["balloonDiameter"] = RoundedJson(catheter.balloonDiameter);
  }
  return json;
}

Json
SmallLevelsToJson(const std::vector<SmallLevel> & levels)
{
  Json list = Json::array();
  for (const SmallLevel & level : levels)
  {
    list.push_back({ { "position", ToJson(level.position) },
                     { "area", RoundedJson(level.area) },
                     { "depth", RoundedJson(level.depth) },
                     { "arcLength", RoundedJson(level.arcLength) } });
  }
  return list;
}

Json
ResidueToJson(const std::vector<ColonResidue> & residue)
{
  Json list = Json::array();
  for (const ColonResidue & one : residue)
  {
    list.push_back({ { "kind", one.structure == ColonStructure::Stool ? one.kind + " stool" : one.kind },
                     { "position", ToJson(one.position) },
                     { "diameter", RoundedJson(one.diameter) },
                     { "intensity", RoundedJson(one.intensity) } });
  }
  return list;
}

Json
DiverticulaToJson(const std::vector<ColonDiverticulum> & diverticula)
{
  Json list = Json::array();
  for (const ColonDiverticulum & one : diverticula)
  {
    list.push_back({ { "id", one.id },
                     { "mouth", ToJson(one.mouth) },
                     { "position", ToJson(one.position) },
                     { "neck", RoundedJson(one.neck) },
                     { "diameter", RoundedJson(one.diameter) },
                     { "arcLength", RoundedJson(one.arcLength) },
                     { "segment", one.segment },
                     { "materialId", one.materialId },
                     { "content", one.content },
                     { "intensity", RoundedJson(one.intensity) } });
  }
  return list;
}

const std::pair<const char *, ColonStructure> colonLabels[] = {
  { "valve", ColonStructure::Valve },           { "ileum", ColonStructure::Ileum },
  { "ileumWall", ColonStructure::IleumWall },   { "catheter", ColonStructure::Catheter },
  { "balloon", ColonStructure::Balloon },       { "stool", ColonStructure::Stool },
  { "bubble", ColonStructure::Bubble },         { "foam", ColonStructure::Foam },
  { "smallBowel", ColonStructure::SmallBowel }, { "stomach", ColonStructure::Stomach },
};
const std::pair<const char *, ColonStructure> chestLabels[] = {
  { "rightUpperLobe", ColonStructure::RightUpperLobe },
  { "rightMiddleLobe", ColonStructure::RightMiddleLobe },
  { "rightLowerLobe", ColonStructure::RightLowerLobe },
  { "leftUpperLobe", ColonStructure::LeftUpperLobe },
  { "leftLowerLobe", ColonStructure::LeftLowerLobe },
  { "airway", ColonStructure::Airway },
  { "airwayWall", ColonStructure::AirwayWall },
  { "lungVessel", ColonStructure::LungVessel },
  { "heart", ColonStructure::Heart },
};

Json
StructuresToJson(const Provenance &      provenance,
                 const ColonAnatomy &    anatomy,
                 const ColonFluid &      fluid,
                 const ColonStructures & structures)
{
  Json json;
  json["provenance"] = ProvenanceToJson(provenance);
  const auto addLabels = [&json](const auto & labels) {
    for (const auto & [name, structure] : labels)
    {
      json["labels"][name] = static_cast<int>(structure);
    }
  };
  addLabels(colonLabels);
  // Files of patients without diverticula remain unchanged.
  if (anatomy.GetParameters().diverticula > 0)
  {
    json["labels"]["diverticulum"] = static_cast<int>(ColonStructure::Diverticulum);
    json["diverticula"] = DiverticulaToJson(structures.GetDiverticula());
  }
  if (HasWholeChest(anatomy.GetParameters()))
  {
    addLabels(chestLabels);
  }
  if (!Contains(anatomy.GetParameters(), "colon"))
  {
    return json;
  }
  json["valve"] = ValveToJson(anatomy);
  json["cecum"] = { { "pole", ToJson(anatomy.CecalPole()) } };
  json["ileum"] = structures.GetIleum() ? IleumToJson(*structures.GetIleum()) : Json();
  json["catheter"] = structures.GetCatheter() ? CatheterToJson(*structures.GetCatheter()) : Json();
  if (structures.GetSigmoidContact())
  {
    json["sigmoidContact"] = ContactToJson(*structures.GetSigmoidContact());
  }
  const auto & filled = fluid.FilledStretch();
  if (filled[1] > filled[0])
  {
    json["filledStretch"] = { RoundedJson(filled[0]), RoundedJson(filled[1]) };
  }
  const TiltedLevel & tilted = fluid.GetTiltedLevel();
  if (tilted.slope > 0.0)
  {
    json["tiltedLevel"] = { { "arcLength", { RoundedJson(tilted.begin), RoundedJson(tilted.end) } },
                            { "slope", RoundedJson(tilted.slope) } };
  }
  if (!fluid.SmallLevels().empty())
  {
    json["smallLevels"] = SmallLevelsToJson(fluid.SmallLevels());
  }
  json["residue"] = ResidueToJson(structures.GetResidue());
  return json;
}

void
WriteTruthOfColon(ColonPhantomImageSource &                             source,
                  const VolumeMetadata &                                facts,
                  const std::function<std::string(const char * name)> & file,
                  const CurveSet *                                      other)
{
  const ColonAnatomy & anatomy = source.GetAnatomy();
  const auto           write = [&](CurveSet curves, const char * name) {
    curves.facts.insert(curves.facts.end(), facts.begin(), facts.end());
    WriteCurves(curves, file(name));
  };
  write(anatomy.Centerline(), "centerline.vtp");
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
  write(source.GetStructures().Axes(), "structures.vtp");
  PolypTable(source.GetFluid(), anatomy).Write(file("polyps.csv"));
}
} // namespace

void
WriteColonTruth(ColonPhantomImageSource & source,
                const Provenance &        provenance,
                const std::string &       folder,
                const OutputPath &        outputPath,
                const CurveSet *          other)
{
  const auto file = [&](const char * name) { return outputPath(folder + '/' + name); };
  const auto facts = ProvenanceMetadata(provenance);
  WriteVolume(source.GetLumenOutput(), file("lumen.nrrd"), facts);
  WriteVolume(source.GetSegmentOutput(), file("segments.nrrd"), facts);
  WriteVolume(source.GetStructureOutput(), file("structures.nrrd"), facts);
  WriteJson(StructuresToJson(provenance, source.GetAnatomy(), source.GetFluid(), source.GetStructures()),
            file("structures.json"));
  if (Contains(source.GetParameters(), "colon"))
  {
    WriteTruthOfColon(source, facts, file, other);
  }
}
} // namespace shapeton
