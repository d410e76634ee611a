#include "shapetonThoraxParts.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonAbdomen.h"
#include "shapetonColonBody.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;

constexpr double fat = -105.0;              // HU
constexpr double muscle = 55.0;             // HU
constexpr double blood = 42.0;              // HU
constexpr double esophagusIntensity = 35.0; // HU
constexpr double diaphragm = 3.0;           // thickness of the diaphragm, mm
constexpr double vesselFat = 3.5;           // thickness of the fat around the great vessels, mm
constexpr double heartFat = 5.0;            // thickness of the fat around the heart, mm
constexpr double skinOfShoulders = 2.0;     // thickness, mm
constexpr double shoulderFat = 12.0;        // depth of the muscles of shoulders and neck below the skin, mm
constexpr double trunkFat = 14.0;           // depth of the muscles of the trunk below the skin, mm
constexpr double shoulderBase = 215.0;      // z (mm) above which shoulders replace the wall of the abdomen
constexpr double chestBase = 60.0;          // z (mm) of the lower end of the chest
constexpr double capBase = 170.0;           // z (mm) above which the rib cage narrows; above the default field of view

PhantomSolid
Union(const std::vector<PhantomSolid> & solids)
{
  double slope = 1.0;
  for (const auto & solid : solids)
  {
    slope = std::max(slope, solid.slope);
  }
  return { [solids](const PointType & p) {
            double least = solids.front().distance(p);
            for (std::size_t i = 1; i < solids.size(); ++i)
            {
              least = std::min(least, solids[i].distance(p));
            }
            return least;
          },
           slope };
}

// The skin of shoulders and neck.
PhantomSolid
ShouldersAndNeck()
{
  const auto shoulders = EllipsoidSolid(MakePoint(0, 12, 225), MakeVector(192, 146, 168), bodyExponent);
  const auto neck = ColumnSolid(0, 56, 62, 74);
  return Either(shoulders, neck);
}

void
AddShoulders(PhantomBodies & bodies)
{
  const auto trunk = ShouldersAndNeck();
  const auto upper = Both(BodyOutline(), Above(230.0));
  const auto chest = Both(Both(Grown(BodyOutline(), -trunkFat), Grown(trunk, -shoulderFat)), Above(shoulderBase));
  AddPart(bodies, chest, muscle);
  // Fat between the muscles, in the armpits and under the pectoral muscles.
  for (const double side : { -1.0, 1.0 })
  {
    const auto armpit = EllipsoidSolid(MakePoint(side * 136, 0, 290), MakeVector(22, 46, 62));
    const auto aboveClavicle = EllipsoidSolid(MakePoint(side * 66, 10, 362), MakeVector(34, 40, 14));
    AddPart(bodies, Both(armpit, chest), fat);
    AddPart(bodies, Both(aboveClavicle, chest), fat);
  }
  constexpr double skin = 10.0; // HU
  const auto       front = Both(HalfSpaceSolid(MakeVector(0, 1, 0), 0.0), Above(shoulderBase));
  const auto       underPectorals = ShellOf(Grown(ThoracicCage(), 12.0), 2.5);
  const auto       underSkin = Both(Without(upper, Grown(trunk, -shoulderFat)), Above(300.0));
  AddPart(bodies, Both(Both(underPectorals, front), chest), fat);
  AddPart(bodies, underSkin, fat);
  AddPart(bodies, Without(upper, Grown(trunk, -skinOfShoulders)), skin);
  AddPart(bodies, Without(upper, trunk), airIntensity);
}

PhantomSolid
GreatVessels()
{
  const auto aorta =
    Either(TubeSolid({ MakePoint(6, -18, 212), MakePoint(-8, -26, 258), MakePoint(2, -10, 280) }, 14.0),
           TubeSolid({ MakePoint(2, -10, 280),
                       MakePoint(14, 14, 286),
                       MakePoint(20, 38, 274),
                       MakePoint(20, 48, 250),
                       MakePoint(13, 48, 145) },
                     11.5));
  const auto branches =
    Union({ TubeSolid({ MakePoint(-2, -12, 285), MakePoint(-20, 2, 335), MakePoint(-30, 22, 420) }, 5.5),
            TubeSolid({ MakePoint(10, 6, 288), MakePoint(16, 12, 335), MakePoint(30, 22, 420) }, 4.0),
            TubeSolid({ MakePoint(17, 22, 284), MakePoint(24, 20, 330), MakePoint(62, 4, 352) }, 4.5) });
  const auto veins =
    Union({ TubeSolid({ MakePoint(-26, -10, 205), MakePoint(-25, -14, 300) }, 9.0),
            TubeSolid({ MakePoint(-25, -14, 300), MakePoint(-38, -8, 345), MakePoint(-40, 22, 420) }, 6.5),
            TubeSolid({ MakePoint(-25, -14, 298), MakePoint(14, -26, 312), MakePoint(40, -8, 346) }, 6.0),
            TubeSolid({ MakePoint(-18, 20, 150), MakePoint(-24, -6, 190) }, 11.0) });
  return Union({ aorta, branches, veins });
}
} // namespace

PhantomSolid
ThoracicCage()
{
  const auto cap = EllipsoidSolid(MakePoint(0, 9, capBase), MakeVector(149, 106, 180), bodyExponent);
  return { [cap](const PointType & p) { return cap.distance(MakePoint(p[0], p[1], std::max(p[2], capBase))); },
           cap.slope };
}

PhantomSolid
Heart()
{
  const auto leftVentricle = CapsuleSolid(MakePoint(8, -14, 206), MakePoint(52, -36, 186), 38.0);
  const auto rightVentricle = CapsuleSolid(MakePoint(-4, -40, 206), MakePoint(40, -58, 182), 30.0);
  const auto rightAtrium = EllipsoidSolid(MakePoint(-28, -14, 204), MakeVector(27, 34, 40));
  const auto leftAtrium = EllipsoidSolid(MakePoint(4, 20, 222), MakeVector(38, 22, 24));
  return Union({ leftVentricle, rightVentricle, rightAtrium, leftAtrium });
}

PhantomSolid
Mediastinum()
{
  const auto spine = Either(ColumnSolid(0, 74, 31, 26), ColumnSolid(0, 100, 44, 26));
  const auto airways = TubeSolid({ MakePoint(0, 30, 290), MakePoint(0, 30, 420) }, 19.0);
  const auto hila = TubeSolid({ MakePoint(-24, 22, 236), MakePoint(0, 26, 250), MakePoint(28, 26, 236) }, 20.0);
  const auto below = TubeSolid({ MakePoint(4, 40, 60), MakePoint(2, 34, 240), MakePoint(0, 30, 290) }, 24.0);
  const auto underHeart = TubeSolid(
    { MakePoint(-22, 10, 168), MakePoint(0, -44, 168), MakePoint(46, -42, 164), MakePoint(4, 20, 168) }, 24.0);
  const auto front = BoxSolid(MakePoint(0, -60, 250), MakeVector(2.5, 60, 150));
  return Union(
    { Grown(Heart(), heartFat), underHeart, below, spine, Grown(GreatVessels(), vesselFat), airways, hila, front });
}

PhantomSolid
RightHemidiaphragm(double lift)
{
  const auto center = MakePoint(-72, 8, 112 + lift);
  const auto radii = MakeVector(68, 84, 70);
  return EllipsoidSolid(center, radii);
}

PhantomSolid
LeftHemidiaphragm(double lift)
{
  const auto center = MakePoint(80, 10, 108 + lift);
  const auto radii = MakeVector(60, 78, 62);
  return EllipsoidSolid(center, radii);
}

void
AddThorax(PhantomBodies & bodies, const ColonAnatomy & anatomy, double lift)
{
  constexpr double wallMuscle = 8.0;    // thickness of the muscles on the ribs, mm
  constexpr double wallThickness = 3.0; // mm
  constexpr double colonGap = 5.0;      // mm between colon and the organs below the diaphragm
  const auto &     p = anatomy.GetParameters();
  AddShoulders(bodies);
  AddPart(bodies, Both(Grown(ThoracicCage(), wallMuscle), Above(shoulderBase)), muscle);
  const auto chest = Without(Both(ThoracicCage(), Above(chestBase)), DiaphragmDome());
  AddPart(bodies, chest, softTissueIntensity);
  const auto inside = Both(Grown(chest, -wallThickness), Above(chestBase));
  AddPart(bodies, Both(Without(inside, Grown(DiaphragmDome(), diaphragm)), Mediastinum()), fat);
  const auto dome = [&](const PhantomSolid & solid, const char * organ, double intensity) {
    const auto part = Both(Grown(solid, -diaphragm), inside);
    AddPart(bodies, Both(solid, inside), softTissueIntensity);
    AddPart(bodies, AwayFromColon(part, anatomy, colonGap), Contains(p, organ) ? intensity : fat);
  };
  dome(RightHemidiaphragm(lift), "liver", liverIntensity);
  dome(LeftHemidiaphragm(lift), "spleen", spleenIntensity);
  const auto aboveAbdomen = Without(Above(150.0), DiaphragmDome());
  if (Contains(p, "vessels"))
  {
    AddPart(bodies, Both(GreatVessels(), aboveAbdomen), blood);
  }
  if (Contains(p, "heart"))
  {
    AddPart(bodies, Both(Heart(), inside), blood);
  }
  const auto esophagus =
    TubeSolid({ MakePoint(6, 36, 150), MakePoint(-3, 43, 200), MakePoint(0, 44, 290), MakePoint(2, 44, 420) }, 6.5);
  AddPart(bodies, Both(esophagus, aboveAbdomen), esophagusIntensity);
}
} // namespace shapeton
