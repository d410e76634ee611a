#include "shapetonAbdomenParts.h"

#include "shapetonThoraxParts.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;

constexpr double cortex = 700.0;
constexpr double vertebraPitch = 36.0; // mm
constexpr double discHeight = 9.0;
constexpr double lumbosacral = -52.0; // z of the top of the sacrum

void
AddBone(PhantomBodies & bodies, const PhantomSolid & bone, double thickness, double marrow)
{
  bodies.push_back(MakeSolidBody(bone, cortex));
  bodies.push_back(MakeSolidBody(Grown(bone, -thickness), marrow));
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
  const auto body = ColumnSolid(0.0, 72.0, 25.0, 18.0, 2.5);
  const auto high = HalfSpaceSolid(MakeVector(0, 0, -1), -lumbosacral);
  bodies.push_back(MakeSolidBody(Both(Grown(body, -1.0), high), 90.0)); // discs
  const auto arch = Both(ColumnSolid(0.0, 100.0, 17.0, 15.0), Behind(86.0));
  AddBone(bodies, EachVertebra(arch, 26.0), 2.5, 450.0);
  AddBone(bodies, EachVertebra(BoxSolid(MakePoint(0, 118, 0), MakeVector(3.5, 12, 1000)), 18.0), 1.2, 350.0);
  AddBone(bodies, EachVertebra(BoxSolid(MakePoint(0, 97, 0), MakeVector(38, 3.5, 1000)), 8.0), 1.2, 350.0);
  AddBone(bodies, EachVertebra(body, vertebraPitch - discHeight), 1.5, 190.0);
  bodies.push_back(MakeSolidBody(Both(ColumnSolid(0.0, 99.0, 10.0, 8.5), high), 20.0)); // canal
}

// Follows SpineAxis(), with a narrow tip.
PhantomSolid
Sacrum()
{
  const auto distance = [](const PointType & p) {
    const double along = std::clamp((lumbosacral - p[2]) / 85.0, 0.0, 1.0);
    const double width = 52.0 - 40.0 * along;
    const double depth = 19.0 - 11.0 * along;
    const double x = p[0] / width;
    const double y = (p[1] - ColonAnatomy::SpineAxis(p[2])[1]) / depth;
    const double section = (std::hypot(x, y) - 1.0) * depth;
    return std::max({ section, p[2] - lumbosacral, lumbosacral - 88.0 - p[2] });
  };
  return { distance, 2.2 };
}

void
AddPelvis(PhantomBodies & bodies)
{
  AddBone(bodies, Sacrum(), 1.8, 200.0);
  // The wings of the ilium widen upward.
  const auto bowl = ShellOf(EllipsoidSolid(MakePoint(0, 34, -35), MakeVector(136, 78, 152), 2.5), 11.0);
  const auto slab = Both(HalfSpaceSolid(MakeVector(0, 0, 1), -34.0), HalfSpaceSolid(MakeVector(0, 0, -1), 172.0));
  const auto front = HalfSpaceSolid(MakeVector(0, -0.9578, -0.2873), 38.0);
  for (const double side : { -1.0, 1.0 })
  {
    const auto lateral = HalfSpaceSolid(MakeVector(-side * 0.9055, 0.4243, 0.0), -12.0);
    AddBone(bodies, Both(Both(bowl, slab), Both(lateral, front)), 2.0, 260.0);
    const auto socket = EllipsoidSolid(MakePoint(side * 93, 6, -152), MakeVector(33, 33, 33));
    AddBone(bodies, socket, 2.5, 300.0);
    bodies.push_back(MakeSolidBody(EllipsoidSolid(MakePoint(side * 97, 3, -156), MakeVector(27, 27, 27)), 60.0));
    AddBone(bodies, EllipsoidSolid(MakePoint(side * 97, 3, -156), MakeVector(24, 24, 24)), 2.0, 320.0);
  }
}

constexpr double ribDescent = 105.0; // mm from spine to sternum, for a complete rib

// A rib descends from the spine to the front, along the chest wall.
PhantomSolid
Rib(double height, const PhantomSolid & wall, double descent = ribDescent)
{
  const auto distance = [wall, height, descent](const PointType & p) {
    const double     turn = std::atan2(std::abs(p[0]), p[1] - 11.0) / 3.14159265358979;
    const double     along = 0.75 * (p[2] - (height - descent * std::min(turn, 0.75)));
    constexpr double far = 40.0;
    if (std::abs(along) > far)
    {
      return std::abs(along) / 1.5 - 4.5;
    }
    const double across = wall.distance(p);
    return std::max(std::hypot(along / 1.5, across) - 4.5, 24.0 - std::abs(p[0]));
  };
  return { distance, 1.6 * wall.slope };
}

void
AddRibs(PhantomBodies & bodies)
{
  const auto wall = ColumnSolid(0.0, 11.0, 154.0, 112.0, 2.5);
  for (int i = 0; i < 6; ++i)
  {
    const double height = 95.0 + 27.0 * i;
    // The lowest ribs are short; the others end in cartilage.
    const double end = i == 0 ? 60.0 : (i == 1 ? 0.0 : -55.0);
    bodies.push_back(MakeSolidBody(Both(Rib(height, wall), Behind(i < 2 ? end : -80.0)), 110.0));
    AddBone(bodies, Both(Rib(height, wall), Behind(end)), 1.4, 250.0);
  }
}
// The upper five ribs on each side; the uppermost two descend less.
void
AddUpperRibs(PhantomBodies & bodies)
{
  const auto       wall = Grown(ThoracicCage(), 4.5);
  constexpr double heights[] = { 257.0, 284.0, 309.0, 331.0, 345.0 };
  constexpr double descents[] = { ribDescent, ribDescent, 98.0, 80.0, 52.0 };
  for (int i = 0; i < 5; ++i)
  {
    const auto rib = Rib(heights[i], wall, descents[i]);
    bodies.push_back(MakeSolidBody(rib, 110.0));
    AddBone(bodies, Both(rib, Behind(-58.0 + 6.0 * i)), 1.4, 250.0);
  }
}

void
AddSternum(PhantomBodies & bodies)
{
  const auto plate = ShellOf(Grown(ThoracicCage(), 5.0), 10.0);
  const auto front = HalfSpaceSolid(MakeVector(0, 1, 0), -20.0);
  AddBone(bodies, Both(BoxSolid(MakePoint(0, -100, 226), MakeVector(17, 100, 64)), Both(plate, front)), 1.5, 220.0);
  AddBone(bodies, Both(BoxSolid(MakePoint(0, -80, 306), MakeVector(27, 80, 16)), Both(plate, front)), 1.5, 220.0);
}
} // namespace

void
AddThoraxBones(PhantomBodies & bodies)
{
  AddUpperRibs(bodies);
  AddSternum(bodies);
  for (const double side : { -1.0, 1.0 })
  {
    const std::vector<PointType> clavicle{ MakePoint(side * 24, -64, 322),
                                           MakePoint(side * 62, -66, 334),
                                           MakePoint(side * 100, -38, 344),
                                           MakePoint(side * 132, -14, 338) };
    AddBone(bodies, TubeSolid(clavicle, 5.5), 1.8, 250.0);
    // The scapula: a plate outside the ribs with a spine.
    const auto plate = ShellOf(Grown(ThoracicCage(), 16.0), 5.0);
    const auto outline = BoxSolid(MakePoint(side * 104, 62, 268), MakeVector(46, 44, 62));
    const auto edge = HalfSpaceSolid(MakeVector(side * 0.78, 0.0, -0.6258), -58.0);
    AddBone(bodies, Both(Both(outline, edge), plate), 1.5, 250.0);
    AddBone(bodies, CapsuleSolid(MakePoint(side * 72, 98, 296), MakePoint(side * 138, 62, 330), 5.0), 1.5, 250.0);
  }
}

void
AddBones(PhantomBodies & bodies)
{
  AddSpine(bodies);
  AddPelvis(bodies);
  AddRibs(bodies);
}
} // namespace shapeton
