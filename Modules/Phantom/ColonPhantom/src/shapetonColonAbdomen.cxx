#include "shapetonColonAbdomen.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonBody.h"
#include "shapetonColonStructurePart.h"
#include "shapetonSmallBowel.h"

namespace shapeton
{
PhantomBodies
MakeColonAbdomen(const ColonAnatomy & anatomy, const ColonFluid & fluid, const ColonStructures & structures)
{
  const auto    down = MakeVector(fluid.Down()[0], fluid.Down()[1], fluid.Down()[2]);
  const auto &  parameters = anatomy.GetParameters();
  PhantomBodies bodies;
  AddTable(bodies, parameters.position);
  AddBodyWall(bodies);
  AddChest(bodies, anatomy);
  AddOrgans(bodies, anatomy, down);
  AddMesentery(bodies, parameters.seed);
  bodies.push_back(MakeSmallBowel(parameters.seed, down, parameters.smallBowelTagged).body);
  AddBones(bodies);
  bodies.push_back(MakeSolidBody(Both(NatalCleft(anatomy), BodyOutline()), airIntensity));
  const auto add = [&](bool behindColon) {
    for (const auto & part : structures.GetParts())
    {
      if (part.body && part.isBehindColon == behindColon)
      {
        bodies.push_back(part.body);
      }
    }
  };
  add(true);
  if (!KeepsPublishedVoxels(parameters))
  {
    for (const ColonPolyp & polyp : anatomy.Polyps())
    {
      bodies.push_back(MakeSolidBody(PolypSolid(polyp), softTissueIntensity));
    }
  }
  bodies.push_back(MakeColonBody(anatomy, fluid));
  add(false);
  return bodies;
}
} // namespace shapeton
