#include "shapetonColonAbdomen.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonBody.h"
#include "shapetonSmallBowel.h"

namespace shapeton
{
PhantomBodies
MakeColonAbdomen(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  const auto    down = MakeVector(fluid.Down()[0], fluid.Down()[1], fluid.Down()[2]);
  const auto &  parameters = anatomy.GetParameters();
  PhantomBodies bodies;
  AddTable(bodies, parameters.position);
  AddBodyWall(bodies);
  AddChest(bodies, anatomy);
  AddOrgans(bodies, anatomy, down);
  AddMesentery(bodies, parameters.seed);
  bodies.push_back(MakeSmallBowel(parameters.seed, down));
  AddBones(bodies);
  bodies.push_back(MakeSolidBody(Both(NatalCleft(anatomy), BodyOutline()), airIntensity));
  bodies.push_back(MakeColonBody(anatomy, fluid));
  for (const auto & body : MakeCatheter(anatomy))
  {
    bodies.push_back(body);
  }
  return bodies;
}
} // namespace shapeton
