#include "shapetonAbdomenParts.h"

#include "shapetonThoraxParts.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;

constexpr double cortex = 700.0; // HU

/** Thickness of the cortex (mm) and intensity of the marrow (HU) of a bone. */
struct BoneTissue
{
  double thickness;
  double marrow;
};
// Chosen from typical anatomy; not fitted.
constexpr BoneTissue archBone{ 2.5, 450.0 };
constexpr BoneTissue processBone{ 1.2, 350.0 };
constexpr BoneTissue vertebraBone{ 1.5, 190.0 };
constexpr BoneTissue sacrumBone{ 1.8, 200.0 };
constexpr BoneTissue iliumBone{ 2.0, 260.0 };
constexpr BoneTissue socketBone{ 2.5, 300.0 };
constexpr BoneTissue femurBone{ 2.0, 320.0 };
constexpr BoneTissue pubicBone{ 2.0, 260.0 };
constexpr BoneTissue ribBone{ 1.4, 250.0 };
constexpr BoneTissue sternumBone{ 1.5, 220.0 };
constexpr BoneTissue clavicleBone{ 1.8, 250.0 };
constexpr BoneTissue scapulaBone{ 1.5, 250.0 };
constexpr double     costalCartilage = 110.0; // HU

constexpr double vertebraPitch = 36.0; // mm
constexpr double discHeight = 9.0;     // mm
constexpr double lumbosacral = -52.0;  // z of the top of the sacrum

void
AddBone(PhantomBodies & bodies, const PhantomSolid & bone, const BoneTissue & tissue)
{
  bodies.push_back(MakeSolidBody(bone, cortex));
  bodies.push_back(MakeSolidBody(Grown(bone, -tissue.thickness), tissue.marrow));
}

// Height relative to the center of the nearest vertebra.
double
InVertebra(double z)
{
  const double turns = (z - lumbosacral) / vertebraPitch;
  return (turns - std::floor(turns) - 0.5) * vertebraPitch;
}

// Repeats a solid of at most `height` mm around the center of each vertebra.
PhantomSolid
EachVertebra(const PhantomSolid & section, double height)
{
  const auto inside = section.distance;
  return { [inside, height](const PointType & p) {
            return std::max({ inside(p), std::abs(InVertebra(p[2])) - 0.5 * height, lumbosacral - p[2] });
          },
           section.slope };
}

PhantomSolid
Behind(double y)
{
  return HalfSpaceSolid(MakeVector(0, -1, 0), -y);
}

void
AddSpine(PhantomBodies & bodies)
{
  constexpr double discs = 90.0; // HU
  constexpr double fluid = 20.0; // HU
  const auto       body = ColumnSolid(0.0, 72.0, 25.0, 18.0, bodyExponent);
  const auto       high = HalfSpaceSolid(MakeVector(0, 0, -1), -lumbosacral);
  const auto       arch = EachVertebra(Both(ColumnSolid(0.0, 100.0, 17.0, 15.0), Behind(86.0)), 26.0);
  const auto       spinous = EachVertebra(BoxSolid(MakePoint(0, 118, 0), MakeVector(3.5, 12, 1000)), 18.0);
  const auto       transverse = EachVertebra(BoxSolid(MakePoint(0, 97, 0), MakeVector(38, 3.5, 1000)), 8.0);
  const auto       canal = Both(ColumnSolid(0.0, 99.0, 10.0, 8.5), high);
  bodies.push_back(MakeSolidBody(Both(Grown(body, -1.0), high), discs));
  AddBone(bodies, arch, archBone);
  AddBone(bodies, spinous, processBone);
  AddBone(bodies, transverse, processBone);
  AddBone(bodies, EachVertebra(body, vertebraPitch - discHeight), vertebraBone);
  bodies.push_back(MakeSolidBody(canal, fluid));
}

// Follows SpineAxis(), with a narrow tip.
PhantomSolid
Sacrum()
{
  constexpr double height = 88.0; // mm
  constexpr double slope = 2.2;   // covers the taper and the bend
  const auto       distance = [](const PointType & p) {
    const double along = std::clamp((lumbosacral - p[2]) / 85.0, 0.0, 1.0);
    const double width = 52.0 - 40.0 * along;
    const double depth = 19.0 - 11.0 * along;
    const double x = p[0] / width;
    const double y = (p[1] - ColonAnatomy::SpineAxis(p[2])[1]) / depth;
    const double section = (std::hypot(x, y) - 1.0) * depth;
    return std::max({ section, p[2] - lumbosacral, lumbosacral - height - p[2] });
  };
  return { distance, slope };
}

void
AddPelvis(PhantomBodies & bodies)
{
  AddBone(bodies, Sacrum(), sacrumBone);
  // The wings of the ilium widen upward.
  const auto bowl = ShellOf(EllipsoidSolid(MakePoint(0, 34, -35), MakeVector(136, 78, 152), bodyExponent), 11.0);
  const auto slab = Both(HalfSpaceSolid(MakeVector(0, 0, 1), -34.0), HalfSpaceSolid(MakeVector(0, 0, -1), 172.0));
  const auto front = HalfSpaceSolid(MakeVector(0, -0.9578, -0.2873), 38.0);
  // The head of the femur, with the joint around it.
  constexpr double joint = 60.0; // HU
  for (const double side : { -1.0, 1.0 })
  {
    const auto lateral = HalfSpaceSolid(MakeVector(-side * 0.9055, 0.4243, 0.0), -12.0);
    AddBone(bodies, Both(Both(bowl, slab), Both(lateral, front)), iliumBone);
    const auto socket = EllipsoidSolid(MakePoint(side * 93, 6, -152), MakeVector(33, 33, 33));
    const auto capsule = EllipsoidSolid(MakePoint(side * 97, 3, -156), MakeVector(27, 27, 27));
    const auto femur = EllipsoidSolid(MakePoint(side * 97, 3, -156), MakeVector(24, 24, 24));
    AddBone(bodies, socket, socketBone);
    bodies.push_back(MakeSolidBody(capsule, joint));
    AddBone(bodies, femur, femurBone);
  }
}

// The bodies and upper branches of the pubic bones, and the symphysis in between, below the space for the colon. The
// pelvic brim is the plane through the promontory of the sacrum and the top of the symphysis.
void
AddPubis(PhantomBodies & bodies)
{
  constexpr double branch = 7.5;      // mm, radius
  constexpr double disc = 2.5;        // mm, half width of the symphysis
  constexpr double cartilage = 100.0; // HU
  const auto       symphysis = EllipsoidSolid(MakePoint(0, -66, -153), MakeVector(14, 10, 19), bodyExponent);
  const auto       pubis = [&](double side) {
    const std::vector<PointType> axis{ MakePoint(side * 9, -66, -146),
                                       MakePoint(side * 38, -58, -142),
                                       MakePoint(side * 72, -22, -146) };
    const auto                   lateral = HalfSpaceSolid(MakeVector(-side, 0, 0), -disc);
    return Both(Either(symphysis, TubeSolid(axis, branch)), lateral);
  };
  bodies.push_back(MakeSolidBody(symphysis, cartilage));
  for (const double side : { -1.0, 1.0 })
  {
    AddBone(bodies, pubis(side), pubicBone);
  }
}

constexpr double ribDescent = 105.0; // mm from spine to sternum, for a complete rib
constexpr double ribRadius = 4.5;    // mm, across the chest wall
constexpr double ribHeight = 1.5;    // height of the cross-section of a rib relative to its width
constexpr double ribsApart = 24.0;   // mm between a rib and the median plane

// A rib descends from the spine to the front, along the chest wall.
PhantomSolid
Rib(double height, const PhantomSolid & wall, double descent = ribDescent)
{
  constexpr double slope = 1.6; // covers the descent of the rib along the wall
  const auto       distance = [wall, height, descent](const PointType & p) {
    const double     turn = std::atan2(std::abs(p[0]), p[1] - 11.0) / 3.14159265358979;
    const double     along = 0.75 * (p[2] - (height - descent * std::min(turn, 0.75)));
    constexpr double far = 40.0;
    if (std::abs(along) > far)
    {
      return std::abs(along) / ribHeight - ribRadius;
    }
    const double across = wall.distance(p);
    return std::max(std::hypot(along / ribHeight, across) - ribRadius, ribsApart - std::abs(p[0]));
  };
  return { distance, slope * wall.slope };
}

void
AddRibs(PhantomBodies & bodies)
{
  constexpr double cartilageEnd = -80.0; // y (mm) up to which the cartilage reaches to the front
  const auto       wall = ColumnSolid(0.0, 11.0, 154.0, 112.0, bodyExponent);
  for (int i = 0; i < 6; ++i)
  {
    const double height = 95.0 + 27.0 * i;
    // The lowest ribs are short; the others end in cartilage.
    const double end = i == 0 ? 60.0 : (i == 1 ? 0.0 : -55.0);
    bodies.push_back(MakeSolidBody(Both(Rib(height, wall), Behind(i < 2 ? end : cartilageEnd)), costalCartilage));
    AddBone(bodies, Both(Rib(height, wall), Behind(end)), ribBone);
  }
}

// The upper five ribs on each side; the uppermost two descend less.
void
AddUpperRibs(PhantomBodies & bodies)
{
  constexpr int    count = 5;
  constexpr double heights[count] = { 257.0, 284.0, 309.0, 331.0, 345.0 };
  constexpr double descents[count] = { ribDescent, ribDescent, 98.0, 80.0, 52.0 };
  const auto       wall = Grown(ThoracicCage(), ribRadius);
  for (int i = 0; i < count; ++i)
  {
    const double end = -58.0 + 6.0 * i; // y (mm) of the start of the cartilage
    const auto   rib = Rib(heights[i], wall, descents[i]);
    bodies.push_back(MakeSolidBody(rib, costalCartilage));
    AddBone(bodies, Both(rib, Behind(end)), ribBone);
  }
}

void
AddSternum(PhantomBodies & bodies)
{
  const auto plate = ShellOf(Grown(ThoracicCage(), 5.0), 10.0);
  const auto front = HalfSpaceSolid(MakeVector(0, 1, 0), -20.0);
  const auto body = BoxSolid(MakePoint(0, -100, 226), MakeVector(17, 100, 64));
  const auto manubrium = BoxSolid(MakePoint(0, -80, 306), MakeVector(27, 80, 16));
  AddBone(bodies, Both(body, Both(plate, front)), sternumBone);
  AddBone(bodies, Both(manubrium, Both(plate, front)), sternumBone);
}
} // namespace

void
AddThoraxBones(PhantomBodies & bodies)
{
  AddUpperRibs(bodies);
  AddSternum(bodies);
  for (const double side : { -1.0, 1.0 })
  {
    const auto clavicle = TubeSolid({ MakePoint(side * 24, -64, 322),
                                      MakePoint(side * 62, -66, 334),
                                      MakePoint(side * 100, -38, 344),
                                      MakePoint(side * 132, -14, 338) },
                                    5.5);
    AddBone(bodies, clavicle, clavicleBone);
    // The scapula: a plate with a spine, outside the ribs.
    const auto plate = ShellOf(Grown(ThoracicCage(), 16.0), 5.0);
    const auto outline = BoxSolid(MakePoint(side * 104, 62, 268), MakeVector(46, 44, 62));
    const auto edge = HalfSpaceSolid(MakeVector(side * 0.78, 0.0, -0.6258), -58.0);
    const auto spine = CapsuleSolid(MakePoint(side * 72, 98, 296), MakePoint(side * 138, 62, 330), 5.0);
    AddBone(bodies, Both(Both(outline, edge), plate), scapulaBone);
    AddBone(bodies, spine, scapulaBone);
  }
}

void
AddBones(PhantomBodies & bodies, bool hasPubis)
{
  AddSpine(bodies);
  AddPelvis(bodies);
  if (hasPubis)
  {
    AddPubis(bodies);
  }
  AddRibs(bodies);
}
} // namespace shapeton
