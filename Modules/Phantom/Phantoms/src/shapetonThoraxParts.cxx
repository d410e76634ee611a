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

constexpr double fat = -105.0; // HU
constexpr double muscle = 55.0;
constexpr double blood = 42.0;
constexpr double diaphragm = 3.0; // thickness of the diaphragm, mm
constexpr double vesselFat = 3.5; // thickness of the fat around the great vessels, mm
constexpr double heartFat = 5.0;  // thickness of the fat around the heart, mm
constexpr double capBase = 170.0; // z (mm) above which the rib cage narrows; above the default field of view

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
  return Either(EllipsoidSolid(MakePoint(0, 12, 225), MakeVector(192, 146, 168), 2.5), ColumnSolid(0, 56, 62, 74));
}

void
AddShoulders(PhantomBodies & bodies)
{
  const auto trunk = ShouldersAndNeck();
  const auto upper = Both(BodyOutline(), Above(230.0));
  const auto chest = Both(Both(Grown(BodyOutline(), -14.0), Grown(trunk, -12.0)), Above(215.0));
  AddPart(bodies, chest, muscle);
  // Fat between the muscles, in the armpits and under the pectoral muscles.
  for (const double side : { -1.0, 1.0 })
  {
    const auto armpit = EllipsoidSolid(MakePoint(side * 136, 0, 290), MakeVector(22, 46, 62));
    AddPart(bodies, Both(armpit, chest), fat);
    AddPart(bodies, Both(EllipsoidSolid(MakePoint(side * 66, 10, 362), MakeVector(34, 40, 14)), chest), fat);
  }
  const auto front = Both(HalfSpaceSolid(MakeVector(0, 1, 0), 0.0), Above(215.0));
  AddPart(bodies, Both(Both(ShellOf(Grown(ThoracicCage(), 12.0), 2.5), front), chest), fat);
  AddPart(bodies, Both(Without(upper, Grown(trunk, -12.0)), Above(300.0)), fat);
  AddPart(bodies, Without(upper, Grown(trunk, -2.0)), 10.0);
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
  const auto cap = EllipsoidSolid(MakePoint(0, 9, capBase), MakeVector(149, 106, 180), 2.5);
  return { [cap](const PointType & p) { return cap.distance(MakePoint(p[0], p[1], std::max(p[2], capBase))); },
           cap.slope };
}

PhantomSolid
Heart()
{
  return Union({ CapsuleSolid(MakePoint(8, -14, 206), MakePoint(52, -36, 186), 38.0),
                 CapsuleSolid(MakePoint(-4, -40, 206), MakePoint(40, -58, 182), 30.0),
                 EllipsoidSolid(MakePoint(-28, -14, 204), MakeVector(27, 34, 40)),
                 EllipsoidSolid(MakePoint(4, 20, 222), MakeVector(38, 22, 24)) });
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
  return EllipsoidSolid(MakePoint(-72, 8, 112 + lift), MakeVector(68, 84, 70));
}

PhantomSolid
LeftHemidiaphragm(double lift)
{
  return EllipsoidSolid(MakePoint(80, 10, 108 + lift), MakeVector(60, 78, 62));
}

void
AddThorax(PhantomBodies & bodies, const ColonAnatomy & anatomy, double lift)
{
  const auto & p = anatomy.GetParameters();
  AddShoulders(bodies);
  AddPart(bodies, Both(Grown(ThoracicCage(), 8.0), Above(215.0)), muscle);
  const auto chest = Without(Both(ThoracicCage(), Above(60.0)), DiaphragmDome());
  AddPart(bodies, chest, softTissueIntensity);
  const auto inside = Both(Grown(chest, -3.0), Above(60.0));
  AddPart(bodies, Both(Without(inside, Grown(DiaphragmDome(), diaphragm)), Mediastinum()), fat);
  const auto dome = [&](const PhantomSolid & solid, const char * organ, double intensity) {
    const auto part = Both(Grown(solid, -diaphragm), inside);
    AddPart(bodies, Both(solid, inside), softTissueIntensity);
    AddPart(bodies, AwayFromColon(part, anatomy, 5.0), Contains(p, organ) ? intensity : fat);
  };
  dome(RightHemidiaphragm(lift), "liver", 62.0);
  dome(LeftHemidiaphragm(lift), "spleen", 56.0);
  if (Contains(p, "vessels"))
  {
    AddPart(bodies, Both(GreatVessels(), Without(Above(150.0), DiaphragmDome())), blood);
  }
  if (Contains(p, "heart"))
  {
    AddPart(bodies, Both(Heart(), inside), blood);
  }
  const auto esophagus =
    TubeSolid({ MakePoint(6, 36, 150), MakePoint(-3, 43, 200), MakePoint(0, 44, 290), MakePoint(2, 44, 420) }, 6.5);
  AddPart(bodies, Both(esophagus, Without(Above(150.0), DiaphragmDome())), 35.0);
}
} // namespace shapeton
