#include "shapetonColonAbdomen.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonBody.h"
#include "shapetonColonStructurePart.h"
#include "shapetonLungs.h"
#include "shapetonSmallBowel.h"
#include "shapetonThoraxParts.h"

namespace shapeton
{
namespace
{
void
AddWholeChest(PhantomBodies & bodies, const ColonAnatomy & anatomy, const ColonStructures & structures)
{
  AddThorax(bodies, anatomy, LungStateOf(anatomy.GetParameters()).lift);
  for (const auto & part : structures.GetParts())
  {
    if (part.body && part.isInChest)
    {
      bodies.push_back(part.body);
    }
  }
}

void
AddColon(PhantomBodies & bodies, const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  if (!KeepsPublishedVoxels(anatomy.GetParameters()))
  {
    for (const ColonPolyp & polyp : anatomy.Polyps())
    {
      bodies.push_back(MakeSolidBody(PolypSolid(polyp), softTissueIntensity));
    }
  }
  bodies.push_back(MakeColonBody(anatomy, fluid));
}
} // namespace

PhantomBodies
MakeColonAbdomen(const ColonAnatomy & anatomy, const ColonFluid & fluid, const ColonStructures & structures)
{
  const auto    down = MakeVector(fluid.Down()[0], fluid.Down()[1], fluid.Down()[2]);
  const auto &  parameters = anatomy.GetParameters();
  PhantomBodies bodies;
  if (Contains(parameters, "table"))
  {
    AddTable(bodies, parameters.position);
  }
  AddBodyWall(bodies);
  if (HasWholeChest(parameters))
  {
    AddWholeChest(bodies, anatomy, structures);
  }
  else
  {
    AddChest(bodies, anatomy);
  }
  AddOrgans(bodies, anatomy, down);
  if (Contains(parameters, "vessels"))
  {
    AddMesentery(bodies, parameters.seed);
  }
  if (Contains(parameters, "smallBowel"))
  {
    bodies.push_back(MakeSmallBowel(parameters.seed, down, parameters.smallBowelTagged).body);
  }
  AddBones(bodies, !KeepsPublishedVoxels(parameters));
  if (HasWholeChest(parameters))
  {
    AddThoraxBones(bodies);
  }
  bodies.push_back(MakeSolidBody(Both(NatalCleft(anatomy), BodyOutline()), airIntensity));
  const auto add = [&](bool behindColon) {
    for (const auto & part : structures.GetParts())
    {
      if (part.body && !part.isInChest && part.isBehindColon == behindColon)
      {
        bodies.push_back(part.body);
      }
    }
  };
  add(true);
  if (Contains(parameters, "colon"))
  {
    AddColon(bodies, anatomy, fluid);
  }
  add(false);
  return bodies;
}
} // namespace shapeton
