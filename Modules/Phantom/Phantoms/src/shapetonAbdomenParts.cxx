#include "shapetonAbdomenParts.h"

#include "shapetonColonBody.h"
#include "shapetonPhantomRandom.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace shapeton
{
void
AddPart(PhantomBodies & bodies, const PhantomSolid & solid, double intensity)
{
  bodies.push_back(MakeSolidBody(solid, intensity));
}

PhantomSolid
Above(double z)
{
  return HalfSpaceSolid(MakeVector(0, 0, -1), -z);
}

namespace
{
using PointType = PhantomBody::PointType;

PhantomSolid
Below(double z)
{
  return HalfSpaceSolid(MakeVector(0, 0, 1), z);
}

PhantomSolid
MuscularWall()
{
  return ColumnSolid(0.0, 12.0, 158.0, 116.0, 2.5);
}
} // namespace

PhantomSolid
DiaphragmDome()
{
  return EllipsoidSolid(MakePoint(0, 8, 45), MakeVector(146, 104, 112), 2.5);
}

PhantomSolid
BodyOutline()
{
  return ColumnSolid(0.0, 12.0, 172.0, 130.0, 2.5);
}

PhantomSolid
AbdominalCavity()
{
  return ColumnSolid(0.0, 6.0, 147.0, 101.0, 2.5);
}

void
AddBodyWall(PhantomBodies & bodies)
{
  constexpr double fat = -112.0;
  constexpr double muscle = 55.0;
  AddPart(bodies, BodyOutline(), 10.0);
  AddPart(bodies, Grown(BodyOutline(), -2.0), fat);
  AddPart(bodies, MuscularWall(), muscle);
  AddPart(bodies, AbdominalCavity(), fat);
  for (const double side : { -1.0, 1.0 })
  {
    AddPart(bodies, ColumnSolid(side * 40.0, 112.0, 34.0, 19.0, 2.5), muscle);
    AddPart(bodies, Both(ColumnSolid(side * 66.0, 96.0, 22.0, 12.0), Both(Above(-60.0), Below(70.0))), muscle);
    const std::vector<PointType> psoas{ MakePoint(side * 26.0, 74.0, 70.0),
                                        MakePoint(side * 38.0, 70.0, 0.0),
                                        MakePoint(side * 52.0, 48.0, -70.0),
                                        MakePoint(side * 74.0, 0.0, -125.0),
                                        MakePoint(side * 84.0, -20.0, -175.0) };
    AddPart(bodies, TubeSolid(psoas, 17.0), muscle);
    const auto gluteus = EllipsoidSolid(MakePoint(side * 82.0, 92.0, -135.0), MakeVector(66, 38, 85), 2.5);
    AddPart(bodies, Both(gluteus, Grown(BodyOutline(), -14.0)), muscle);
  }
  AddPart(bodies, CapsuleSolid(MakePoint(0, 52, -190), MakePoint(0, 46, -128), 15.0), muscle);
}

constexpr double plainLungIntensity = -850.0; // HU

void
AddChest(PhantomBodies & bodies, const ColonAnatomy & anatomy)
{
  const auto thorax = ColumnSolid(0.0, 9.0, 149.0, 106.0, 2.5);
  const auto chest = Both(thorax, Above(60.0));
  AddPart(bodies, Without(chest, DiaphragmDome()), softTissueIntensity);
  const auto lungs =
    Without(Without(Grown(chest, -3.0), Grown(DiaphragmDome(), 4.0)), ColumnSolid(0.0, 40.0, 38.0, 90.0));
  const auto & p = anatomy.GetParameters();
  if (Contains(p, "lungs"))
  {
    AddPart(bodies, AwayFromColon(lungs, anatomy, 8.0), plainLungIntensity);
  }
  const auto heart = EllipsoidSolid(MakePoint(28, -40, 195), MakeVector(62, 50, 48));
  if (Contains(p, "heart"))
  {
    AddPart(bodies, Both(Without(heart, DiaphragmDome()), Grown(thorax, -3.0)), 45.0);
  }
}

namespace
{
constexpr double stomachWall = 4.0;
const PointType  stomachCenter = MakePoint(58, -38, 100);
const auto       stomachRadii = MakeVector(46, 32, 40);

PhantomSolid
Stomach(const ColonAnatomy & anatomy)
{
  const auto stomach = Both(EllipsoidSolid(stomachCenter, stomachRadii), Grown(AbdominalCavity(), -2.0));
  return AwayFromColon(stomach, anatomy, 4.0);
}

// Gas fills the upper 14 mm of the stomach.
void
AddStomach(PhantomBodies & bodies, const ColonAnatomy & anatomy, const itk::Vector<double, 3> & down)
{
  const auto lumen = StomachLumen(anatomy);
  double     reach = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    reach += (stomachRadii[i] - stomachWall) * (stomachRadii[i] - stomachWall) * down[i] * down[i];
  }
  const double level = down * stomachCenter.GetVectorFromOrigin() - std::sqrt(reach) + 14.0;
  AddPart(bodies, Stomach(anatomy), 60.0);
  AddPart(bodies, lumen, anatomy.GetParameters().stomachIntensity);
  AddPart(bodies, Both(lumen, HalfSpaceSolid(down, level)), gasIntensity);
}
} // namespace

PhantomSolid
StomachLumen(const ColonAnatomy & anatomy)
{
  return Grown(Stomach(anatomy), -stomachWall);
}

void
AddOrgans(PhantomBodies & bodies, const ColonAnatomy & anatomy, const itk::Vector<double, 3> & down)
{
  const auto   cavity = Both(Grown(AbdominalCavity(), -2.0), DiaphragmDome());
  const auto & p = anatomy.GetParameters();
  const auto   addOf = [&](const char * organ, const PhantomSolid & solid, double gap, double intensity) {
    if (Contains(p, organ))
    {
      AddPart(bodies, AwayFromColon(Both(solid, cavity), anatomy, gap), intensity);
    }
  };
  addOf("liver", EllipsoidSolid(MakePoint(-66, -2, 112), MakeVector(82, 92, 66), 2.5), 5.0, 62.0);
  addOf("liver", EllipsoidSolid(MakePoint(-86, 20, 78), MakeVector(52, 60, 70), 2.5), 5.0, 62.0);
  addOf("spleen", EllipsoidSolid(MakePoint(112, 42, 112), MakeVector(30, 46, 40)), 5.0, 56.0);
  addOf("liver", EllipsoidSolid(MakePoint(-22, -46, 70), MakeVector(16, 18, 24)), 4.0, 15.0);
  for (const double side : { -1.0, 1.0 })
  {
    const double z = side < 0.0 ? 32.0 : 46.0;
    addOf("kidneys", EllipsoidSolid(MakePoint(side * 66, 66, z), MakeVector(26, 24, 54)), 6.0, 60.0);
    addOf("kidneys", EllipsoidSolid(MakePoint(side * 53, 60, z), MakeVector(11, 11, 24)), 6.0, -90.0);
  }
  const std::vector<PointType> aorta{ MakePoint(12, 44, 200), MakePoint(12, 44, -40) };
  const std::vector<PointType> cava{ MakePoint(-16, 46, 200), MakePoint(-16, 46, -40) };
  addOf("vessels", TubeSolid(aorta, 10.0), 4.0, 45.0);
  addOf("vessels", TubeSolid(cava, 11.0), 4.0, 45.0);
  for (const double side : { -1.0, 1.0 })
  {
    addOf("vessels",
          TubeSolid({ MakePoint(0, 45, -38), MakePoint(side * 36, 42, -85), MakePoint(side * 62, -20, -160) }, 8.0),
          3.0,
          45.0);
  }
  addOf("bladder", EllipsoidSolid(MakePoint(0, -40, -138), MakeVector(40, 32, 30)), 4.0, 35.0);
  addOf("bladder", EllipsoidSolid(MakePoint(0, -40, -138), MakeVector(37, 29, 27)), 7.0, 6.0);
  addOf("bladder", EllipsoidSolid(MakePoint(0, 2, -140), MakeVector(25, 17, 22)), 4.0, 50.0);
  if (Contains(p, "stomach"))
  {
    AddStomach(bodies, anatomy, down);
  }
}

// Branches of the aorta.
void
AddMesentery(PhantomBodies & bodies, unsigned seed)
{
  PhantomRandom random(seed, 0x7e55);
  for (int i = 0; i < 60; ++i)
  {
    const auto   root = MakePoint(random.Uniform(-8, 20), random.Uniform(15, 32), random.Uniform(-30, 45));
    const auto   end = MakePoint(random.Uniform(-125, 125), random.Uniform(-80, 40), random.Uniform(-100, 90));
    const auto   bend = MakeVector(random.Uniform(-15, 15), random.Uniform(-15, 15), random.Uniform(-15, 15));
    const auto   middle = root + (end - root) * 0.5 + bend;
    const double radius = random.Uniform(1.3, 3.2);
    AddPart(bodies, Either(CapsuleSolid(root, middle, radius), CapsuleSolid(middle, end, 0.75 * radius)), 48.0);
  }
}

// Foam in a shell, slightly below the skin.
void
AddTable(PhantomBodies & bodies, const std::string & position)
{
  const std::map<std::string, PhantomSolid> tables{
    { "supine", BoxSolid(MakePoint(0, 152.5, 0), MakeVector(205, 9, 1000)) },
    { "prone", BoxSolid(MakePoint(0, -128.5, 0), MakeVector(205, 9, 1000)) },
    { "leftDecubitus", BoxSolid(MakePoint(182.5, 12, 0), MakeVector(9, 205, 1000)) },
    { "rightDecubitus", BoxSolid(MakePoint(-182.5, 12, 0), MakeVector(9, 205, 1000)) }
  };
  const auto & table = tables.at(position);
  AddPart(bodies, table, -350.0);
  AddPart(bodies, Grown(table, -2.0), -920.0);
}
} // namespace shapeton
