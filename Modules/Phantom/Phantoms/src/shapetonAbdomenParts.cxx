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

/** Cross-section of the trunk: its center on the y axis and half axes, mm. */
struct TrunkSection
{
  double y;
  double halfWidth;
  double halfDepth;
};
// Chosen; the trunk of an adult.
constexpr TrunkSection skinSection{ 12.0, 172.0, 130.0 };
constexpr TrunkSection muscleSection{ 12.0, 158.0, 116.0 };
constexpr TrunkSection cavitySection{ 6.0, 147.0, 101.0 };

PhantomSolid
TrunkSolid(const TrunkSection & section)
{
  return ColumnSolid(0.0, section.y, section.halfWidth, section.halfDepth, bodyExponent);
}
} // namespace

PhantomSolid
DiaphragmDome()
{
  const auto center = MakePoint(0, 8, 45);
  const auto radii = MakeVector(146, 104, 112);
  return EllipsoidSolid(center, radii, bodyExponent);
}

PhantomSolid
BodyOutline()
{
  return TrunkSolid(skinSection);
}

PhantomSolid
AbdominalCavity()
{
  return TrunkSolid(cavitySection);
}

void
AddBodyWall(PhantomBodies & bodies)
{
  constexpr double skin = 10.0;         // HU
  constexpr double skinThickness = 2.0; // mm
  constexpr double fat = -112.0;        // HU; as on CT colonographies
  constexpr double muscle = 55.0;       // HU
  constexpr double gluteusDepth = 14.0; // mm of skin and fat over the gluteal muscles
  AddPart(bodies, BodyOutline(), skin);
  AddPart(bodies, Grown(BodyOutline(), -skinThickness), fat);
  AddPart(bodies, TrunkSolid(muscleSection), muscle);
  AddPart(bodies, AbdominalCavity(), fat);
  for (const double side : { -1.0, 1.0 })
  {
    const auto erectorSpinae = ColumnSolid(side * 40.0, 112.0, 34.0, 19.0, bodyExponent);
    const auto quadratus = Both(ColumnSolid(side * 66.0, 96.0, 22.0, 12.0), Both(Above(-60.0), Below(70.0)));
    const auto psoas = TubeSolid({ MakePoint(side * 26.0, 74.0, 70.0),
                                   MakePoint(side * 38.0, 70.0, 0.0),
                                   MakePoint(side * 52.0, 48.0, -70.0),
                                   MakePoint(side * 74.0, 0.0, -125.0),
                                   MakePoint(side * 84.0, -20.0, -175.0) },
                                 17.0);
    const auto gluteus = EllipsoidSolid(MakePoint(side * 82.0, 92.0, -135.0), MakeVector(66, 38, 85), bodyExponent);
    AddPart(bodies, erectorSpinae, muscle);
    AddPart(bodies, quadratus, muscle);
    AddPart(bodies, psoas, muscle);
    AddPart(bodies, Both(gluteus, Grown(BodyOutline(), -gluteusDepth)), muscle);
  }
  const auto pelvicFloor = CapsuleSolid(MakePoint(0, 52, -190), MakePoint(0, 46, -128), 15.0);
  AddPart(bodies, pelvicFloor, muscle);
}

constexpr double plainLungIntensity = -850.0; // HU; as on CT colonographies

void
AddChest(PhantomBodies & bodies, const ColonAnatomy & anatomy)
{
  const auto thorax = ColumnSolid(0.0, 9.0, 149.0, 106.0, bodyExponent);
  const auto chest = Both(thorax, Above(60.0));
  AddPart(bodies, Without(chest, DiaphragmDome()), softTissueIntensity);
  const auto lungs =
    Without(Without(Grown(chest, -3.0), Grown(DiaphragmDome(), 4.0)), ColumnSolid(0.0, 40.0, 38.0, 90.0));
  constexpr double lungGap = 8.0;        // mm between colon and lungs
  constexpr double myocardium = 45.0;    // HU
  constexpr double pericardialFat = 3.0; // mm
  const auto &     p = anatomy.GetParameters();
  if (Contains(p, "lungs"))
  {
    AddPart(bodies, AwayFromColon(lungs, anatomy, lungGap), plainLungIntensity);
  }
  const auto heart = EllipsoidSolid(MakePoint(28, -40, 195), MakeVector(62, 50, 48));
  if (Contains(p, "heart"))
  {
    AddPart(bodies, Both(Without(heart, DiaphragmDome()), Grown(thorax, -pericardialFat)), myocardium);
  }
}

namespace
{
constexpr double stomachWall = 4.0;           // mm
constexpr double stomachWallIntensity = 60.0; // HU
constexpr double stomachGas = 14.0;           // mm from the top of the lumen to the fluid level
constexpr double stomachGap = 4.0;            // mm between colon and stomach
const PointType  stomachCenter = MakePoint(58, -38, 100);
const auto       stomachRadii = MakeVector(46, 32, 40);

PhantomSolid
Stomach(const ColonAnatomy & anatomy)
{
  const auto stomach = Both(EllipsoidSolid(stomachCenter, stomachRadii), Grown(AbdominalCavity(), -2.0));
  return AwayFromColon(stomach, anatomy, stomachGap);
}

// Gas fills the upper part of the stomach.
void
AddStomach(PhantomBodies & bodies, const ColonAnatomy & anatomy, const itk::Vector<double, 3> & down)
{
  const auto lumen = StomachLumen(anatomy);
  double     reach = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    reach += (stomachRadii[i] - stomachWall) * (stomachRadii[i] - stomachWall) * down[i] * down[i];
  }
  const double level = down * stomachCenter.GetVectorFromOrigin() - std::sqrt(reach) + stomachGas;
  AddPart(bodies, Stomach(anatomy), stomachWallIntensity);
  AddPart(bodies, lumen, anatomy.GetParameters().stomachIntensity);
  AddPart(bodies, Both(lumen, HalfSpaceSolid(down, level)), gasIntensity);
}

/** An ellipsoid with the name of its organ in the contents; later rows are painted over earlier ones. */
struct OrganPart
{
  const char * organ;
  double       center[3]; // mm
  double       radii[3];  // mm
  double       exponent;
  double       gap;       // mm between colon and organ
  double       intensity; // HU
};

constexpr OrganPart upperOrgans[] = {
  { "liver", { -66, -2, 112 }, { 82, 92, 66 }, bodyExponent, 5.0, liverIntensity }, // right lobe, upper part
  { "liver", { -86, 20, 78 }, { 52, 60, 70 }, bodyExponent, 5.0, liverIntensity },  // right lobe, lower part
  { "spleen", { 112, 42, 112 }, { 30, 46, 40 }, 2.0, 5.0, spleenIntensity },
  { "liver", { -22, -46, 70 }, { 16, 18, 24 }, 2.0, 4.0, 15.0 },   // gallbladder
  { "kidneys", { -66, 66, 32 }, { 26, 24, 54 }, 2.0, 6.0, 60.0 },  // right kidney
  { "kidneys", { -53, 60, 32 }, { 11, 11, 24 }, 2.0, 6.0, -90.0 }, // fat of its sinus
  { "kidneys", { 66, 66, 46 }, { 26, 24, 54 }, 2.0, 6.0, 60.0 },   // left kidney
  { "kidneys", { 53, 60, 46 }, { 11, 11, 24 }, 2.0, 6.0, -90.0 },  // fat of its sinus
};

constexpr OrganPart pelvicOrgans[] = {
  { "bladder", { 0, -40, -138 }, { 40, 32, 30 }, 2.0, 4.0, 35.0 }, // wall
  { "bladder", { 0, -40, -138 }, { 37, 29, 27 }, 2.0, 7.0, 6.0 },  // urine
  { "bladder", { 0, 2, -140 }, { 25, 17, 22 }, 2.0, 4.0, 50.0 },   // organ between bladder and rectum
};

PhantomSolid
OrganSolid(const OrganPart & part)
{
  const auto & c = part.center;
  const auto & r = part.radii;
  return EllipsoidSolid(MakePoint(c[0], c[1], c[2]), MakeVector(r[0], r[1], r[2]), part.exponent);
}

// The aorta, the inferior vena cava and the common iliac arteries.
std::vector<PhantomSolid>
AbdominalVessels()
{
  constexpr double          aortaRadius = 10.0; // mm
  constexpr double          cavaRadius = 11.0;
  constexpr double          iliacRadius = 8.0;
  const auto                aorta = TubeSolid({ MakePoint(12, 44, 200), MakePoint(12, 44, -40) }, aortaRadius);
  const auto                cava = TubeSolid({ MakePoint(-16, 46, 200), MakePoint(-16, 46, -40) }, cavaRadius);
  std::vector<PhantomSolid> vessels{ aorta, cava };
  for (const double side : { -1.0, 1.0 })
  {
    const std::vector<PointType> iliac{ MakePoint(0, 45, -38),
                                        MakePoint(side * 36, 42, -85),
                                        MakePoint(side * 62, -20, -160) };
    vessels.push_back(TubeSolid(iliac, iliacRadius));
  }
  return vessels;
}
} // namespace

PhantomSolid
PelvicOrgans()
{
  PhantomSolid organs = OrganSolid(pelvicOrgans[0]);
  for (const OrganPart & part : pelvicOrgans)
  {
    organs = Either(organs, OrganSolid(part));
  }
  return organs;
}

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
  const auto addParts = [&](const auto & parts) {
    for (const OrganPart & part : parts)
    {
      addOf(part.organ, OrganSolid(part), part.gap, part.intensity);
    }
  };
  constexpr double vesselIntensity = 45.0;                // HU
  constexpr double vesselGaps[] = { 4.0, 4.0, 3.0, 3.0 }; // mm between colon and each of AbdominalVessels()
  addParts(upperOrgans);
  const std::vector<PhantomSolid> vessels = AbdominalVessels();
  for (std::size_t i = 0; i < vessels.size(); ++i)
  {
    addOf("vessels", vessels[i], vesselGaps[i], vesselIntensity);
  }
  addParts(pelvicOrgans);
  if (Contains(p, "stomach"))
  {
    AddStomach(bodies, anatomy, down);
  }
}

// Branches of the aorta.
void
AddMesentery(PhantomBodies & bodies, unsigned seed)
{
  constexpr int    count = 60;
  constexpr double intensity = 48.0; // HU
  constexpr double taper = 0.75;     // of the radius beyond the bend
  PhantomRandom    random(seed, 0x7e55);
  for (int i = 0; i < count; ++i)
  {
    const auto   root = MakePoint(random.Uniform(-8, 20), random.Uniform(15, 32), random.Uniform(-30, 45));
    const auto   end = MakePoint(random.Uniform(-125, 125), random.Uniform(-80, 40), random.Uniform(-100, 90));
    const auto   bend = MakeVector(random.Uniform(-15, 15), random.Uniform(-15, 15), random.Uniform(-15, 15));
    const auto   middle = root + (end - root) * 0.5 + bend;
    const double radius = random.Uniform(1.3, 3.2);
    AddPart(bodies, Either(CapsuleSolid(root, middle, radius), CapsuleSolid(middle, end, taper * radius)), intensity);
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
  constexpr double shell = -350.0;       // HU
  constexpr double foam = -920.0;        // HU
  constexpr double shellThickness = 2.0; // mm
  const auto &     table = tables.at(position);
  AddPart(bodies, table, shell);
  AddPart(bodies, Grown(table, -shellThickness), foam);
}
} // namespace shapeton
