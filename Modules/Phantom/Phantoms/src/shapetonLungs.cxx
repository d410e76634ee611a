#include "shapetonLungs.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonAbdomen.h"
#include "shapetonColonBody.h"
#include "shapetonForEachCell.h"
#include "shapetonLungTrees.h"
#include "shapetonThoraxParts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;
using VectorType = itk::Vector<double, 3>;

constexpr double tissue = 42.0;       // HU of vessels, walls of airways and fissures
constexpr double pleura = 3.0;        // mm between ribs and lung, and of the diaphragm
constexpr double fissure = 0.4;       // thickness, mm; appears as a thin, faint line after scanner blur
constexpr double forestReach = 6.0;   // mm; distances to airways and vessels are exact up to this value
constexpr double lungFromColon = 8.0; // mm between colon and lungs

const PointType lowCorner = MakePoint(-150.0, -102.0, 60.0); // mm, of a box around the lungs
const PointType highCorner = MakePoint(150.0, 120.0, 352.0); // mm

enum class Stream : std::uint32_t
{
  Texture = 0x1c01,
  Holes,
  Bullae,
  Trees = 0x1d00 // plus the number of the tree
};

PhantomRandom
RandomOf(unsigned seed, Stream stream, unsigned number = 0)
{
  return PhantomRandom(seed, static_cast<std::uint32_t>(stream) + number);
}

// AwayFromColon() for a solid much larger than ColonAnatomy::Reach: inner distances outside the bounding box of the
// colon are unchanged.
PhantomSolid
AwayFromColonsBox(const PhantomSolid & solid, const ColonAnatomy & anatomy, double gap)
{
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  anatomy.BoundingBox(0.0, low, high);
  const Eigen::Vector3d middle = 0.5 * (low + high);
  const Eigen::Vector3d half = 0.5 * (high - low);
  const auto box = BoxSolid(MakePoint(middle[0], middle[1], middle[2]), MakeVector(half[0], half[1], half[2]));
  const auto near = AwayFromColon(solid, anatomy, gap);
  return { [box, near, whole = solid.distance, gap](const PointType & p) {
            const double toBox = box.distance(p);
            return toBox > ColonAnatomy::Reach ? std::max(whole(p), gap - toBox) : near.distance(p);
          },
           near.slope };
}

PhantomSolid
LungSpace(const ColonAnatomy & anatomy, double lift)
{
  const auto cage = Both(Grown(ThoracicCage(), -pleura), HalfSpaceSolid(MakeVector(0, 0, -1), -lowCorner[2]));
  const auto above = Without(cage, Grown(DiaphragmDome(), pleura + 1.0));
  const auto right = Without(above, RightHemidiaphragm(lift));
  const auto left = Without(right, LeftHemidiaphragm(lift));
  return AwayFromColonsBox(Without(left, Mediastinum()), anatomy, lungFromColon);
}

/** The fissures, which divide the lungs into lobes. */
class Lobes
{
public:
  static constexpr double slope = 1.25; // sum of the gradients of waves and planes

  static constexpr int count = 5; // of lobes

  // Distance (mm) above (in front of) the oblique fissure of the side.
  static double
  AboveOblique(const PointType & p)
  {
    const double wave = 3.0 * std::sin(p[0] / 28.0 + 0.7) * std::cos(p[2] / 40.0);
    const double right = -0.676 * p[1] + 0.737 * p[2] - 146.1 + wave;
    const double left = -0.707 * p[1] + 0.707 * p[2] - 143.0 - wave;
    return p[0] < 0.0 ? right : left;
  }

  // Distance (mm) above the horizontal fissure of the right lung.
  static double
  AboveHorizontal(const PointType & p)
  {
    const double wave = 2.5 * std::sin(p[0] / 24.0) * std::cos(p[1] / 30.0);
    const double plane = 0.05 * p[0] - 0.05 * p[1] + 0.9975 * p[2] - 219.4;
    return plane + wave;
  }

  // Unsigned distance (mm) to the nearest fissure.
  static double
  ToFissure(const PointType & p)
  {
    const double oblique = AboveOblique(p);
    const bool   hasHorizontal = p[0] < 0.0 && oblique > 0.0;
    return hasHorizontal ? std::min(oblique, std::abs(AboveHorizontal(p))) : std::abs(oblique);
  }

  // Lobe index 0 to 4: right upper, right middle, right lower, left upper, left lower.
  static int
  At(const PointType & p)
  {
    if (p[0] < 0.0)
    {
      return AboveOblique(p) < 0.0 ? 2 : (AboveHorizontal(p) < 0.0 ? 1 : 0);
    }
    return AboveOblique(p) < 0.0 ? 4 : 3;
  }

  static PhantomSolid
  Lobe(const PhantomSolid & lungs, int number)
  {
    const auto outline = [number](const PointType & p) {
      const double side = number < 3 ? p[0] : -p[0]; // of the lattice of random values; a power of two
      const double oblique = AboveOblique(p);
      if (number == 2 || number == 4)
      {
        return std::max(side, oblique + 0.5 * fissure);
      }
      const double above = std::max(side, 0.5 * fissure - oblique);
      if (number == 3)
      {
        return above;
      }
      const double horizontal = AboveHorizontal(p);
      return std::max(above, 0.5 * fissure + (number == 0 ? -horizontal : horizontal));
    };
    return Both(lungs, { outline, slope });
  }
};

/** Smooth zero-mean noise in about [-1, 1] from a periodic lattice of random numbers. */
class Texture
{
public:
  explicit Texture(unsigned seed) : m_Values(side * side * side)
  {
    PhantomRandom random = RandomOf(seed, Stream::Texture);
    for (float & value : m_Values)
    {
      value = static_cast<float>(random.Uniform(-1.0, 1.0));
    }
  }

  // Sum of lobules of a few mm and regions of a few cm.
  double
  operator()(const PointType & p) const
  {
    constexpr double lobules = 4.5;      // mm between knots
    constexpr double regions = 17.0;     // mm between knots
    constexpr double regionsShare = 0.8; // amplitude relative to the lobules
    return this->Octave(p, lobules) + regionsShare * this->Octave(p, regions);
  }

private:
  static constexpr int side = 32;

  double
  At(int x, int y, int z) const
  {
    const auto wrap = [](int i) { return static_cast<std::size_t>(i & (side - 1)); };
    return m_Values[(wrap(z) * side + wrap(y)) * side + wrap(x)];
  }

  double
  Octave(const PointType & p, double knotDistance) const
  {
    int    first[3];
    double t[3];
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double x = p[i] / knotDistance;
      first[i] = static_cast<int>(std::floor(x));
      t[i] = x - first[i];
      t[i] = t[i] * t[i] * (3.0 - 2.0 * t[i]);
    }
    const auto mix = [](double a, double b, double share) { return a + share * (b - a); };
    const auto line = [&](int y, int z) {
      return mix(
        this->At(first[0], first[1] + y, first[2] + z), this->At(first[0] + 1, first[1] + y, first[2] + z), t[0]);
    };
    return mix(mix(line(0, 0), line(1, 0), t[1]), mix(line(0, 1), line(1, 1), t[1]), t[2]);
  }

  std::vector<float> m_Values;
};

/** The parenchyma of both lungs with fissures. The mean density includes holes. */
class LungBody : public PhantomBody
{
public:
  LungBody(PhantomSolid         lungs,
           const PhantomSolid & holes,
           const PhantomSolid & others,
           const LungState &    state,
           unsigned             seed,
           const VectorType &   down)
    : m_Lungs(std::move(lungs)), m_State(state), m_Down(down), m_Texture(seed)
  {
    this->SetMean(holes, others);
  }

  BodyProbe
  Probe(const PointType & p) const override
  {
    const double distance = m_Lungs.distance(p) / m_Lungs.slope;
    if (distance >= 0.0)
    {
      return { distance, distance, true };
    }
    return { distance, std::min(-distance, (Lobes::ToFissure(p) - 0.5 * fissure) / Lobes::slope), true };
  }

  // Gravity and texture modulate the tissue fraction, so that values are never below air.
  double
  Intensity(const PointType & p) const override
  {
    return airIntensity + m_Tissue * this->Relative(p);
  }

  void
  Paint(const PointType & p, double width, double & value) const override
  {
    const double share = ShareInside(m_Lungs.distance(p), width);
    if (share > 0.0)
    {
      const double toFissure = Lobes::ToFissure(p);
      const double between =
        ShareInside(toFissure - 0.5 * fissure, width) - ShareInside(toFissure + 0.5 * fissure, width);
      const double parenchyma = this->Intensity(p);
      value += share * (parenchyma + between * (tissue - parenchyma) - value);
    }
  }

private:
  double
  Relative(const PointType & p) const
  {
    constexpr double least = 0.1; // of the mean, so that values stay above air
    const double     depth = m_Down * (p - m_Middle);
    return std::max(least, 1.0 + m_State.gravityGradient * depth + m_State.texture * m_Texture(p));
  }

  // Calibrates on a lattice: the mean over the lungs, including holes but not other structures, matches the state.
  void
  SetMean(const PhantomSolid & holes, const PhantomSolid & others)
  {
    constexpr double       step = 5.0; // mm
    std::vector<PointType> points;
    VectorType             sum(0.0);
    double                 inHoles = 0.0;
    ForEachCell(lowCorner, highCorner, step, [&](const PointType & p) {
      if (m_Lungs.distance(p) >= 0.0 || others.distance(p) < 0.0)
      {
        return;
      }
      if (holes.distance(p) < 0.0)
      {
        inHoles += 1.0;
        return;
      }
      points.push_back(p);
      sum += p.GetVectorFromOrigin();
    });
    const auto count = static_cast<double>(points.size());
    m_Middle = PointType(0.0) + sum / count;
    double relative = 0.0;
    for (const PointType & p : points)
    {
      relative += this->Relative(p);
    }
    const double wanted =
      (count + inHoles) * (m_State.density - airIntensity) - inHoles * (gasIntensity - airIntensity);
    m_Tissue = std::max(0.0, wanted / relative);
  }

  PhantomSolid m_Lungs;
  LungState    m_State;
  VectorType   m_Down;
  Texture      m_Texture;
  PointType    m_Middle{ 0.0 };
  double       m_Tissue{ 0.0 }; // HU above air without modulation
};

/** Trees of one kind: trunks, then one tree per lobe from the end of a trunk. */
struct TreePlan
{
  std::vector<TaperedTube>            trunks;
  std::array<PointType, Lobes::count> roots;
  double                              spacing;   ///< spacing of the tips, mm
  double                              tipRadius; ///< mm
};

struct Position
{
  double x;
  double y;
  double z;
};

/** Ends (mm) of a trunk, with the radii (mm) there. */
struct Trunk
{
  Position from;
  Position to;
  double   fromRadius;
  double   toRadius;
};

template <std::size_t VTrunks>
TreePlan
PlanOf(const Trunk (&trunks)[VTrunks], const Position (&roots)[Lobes::count], double spacing, double tipRadius)
{
  const auto pointOf = [](const Position & p) { return MakePoint(p.x, p.y, p.z); };
  TreePlan   plan;
  for (const Trunk & trunk : trunks)
  {
    plan.trunks.push_back({ pointOf(trunk.from), pointOf(trunk.to), trunk.fromRadius, trunk.toRadius });
  }
  std::transform(std::begin(roots), std::end(roots), plan.roots.begin(), pointOf);
  plan.spacing = spacing;
  plan.tipRadius = tipRadius;
  return plan;
}

TreePlan
Arteries()
{
  constexpr double   spacing = 14.0;  // mm
  constexpr double   tipRadius = 0.8; // mm
  constexpr Position fork{ 16, -8, 250 };
  constexpr Position right{ -38, 8, 242 };
  constexpr Position left{ 40, 16, 257 };
  constexpr Trunk    trunks[] = {
       { { 22, -42, 222 }, fork, 13.5, 12.5 }, { fork, right, 11.0, 9.5 },           { fork, left, 11.0, 9.5 },
       { right, { -44, 12, 252 }, 7.0, 6.0 },  { right, { -48, 4, 230 }, 7.5, 5.0 }, { right, { -50, 20, 226 }, 8.5, 7.0 },
       { left, { 46, 8, 258 }, 8.0, 6.5 },     { left, { 52, 32, 240 }, 9.0, 7.5 },
  };
  constexpr Position roots[] = { { -44, 12, 252 }, { -48, 4, 230 }, { -50, 20, 226 }, { 46, 8, 258 }, { 52, 32, 240 } };
  return PlanOf(trunks, roots, spacing, tipRadius);
}

TreePlan
Veins()
{
  constexpr double spacing = 15.0;  // mm
  constexpr double tipRadius = 0.8; // mm
  constexpr Trunk  trunks[] = {
     { { -20, 12, 226 }, { -46, -2, 238 }, 8.0, 6.0 }, { { -20, 12, 222 }, { -46, -6, 216 }, 7.0, 5.0 },
     { { -20, 22, 216 }, { -46, 30, 204 }, 8.0, 6.5 }, { { 28, 14, 228 }, { 50, -4, 240 }, 8.0, 6.0 },
     { { 28, 24, 218 }, { 50, 36, 206 }, 8.0, 6.5 },
  };
  constexpr Position roots[] = {
    { -46, -2, 238 }, { -46, -6, 216 }, { -46, 30, 204 }, { 50, -4, 240 }, { 50, 36, 206 }
  };
  return PlanOf(trunks, roots, spacing, tipRadius);
}

TreePlan
Airways()
{
  constexpr double   spacing = 30.0;  // mm
  constexpr double   tipRadius = 0.9; // mm
  constexpr Position carina{ 0, 24, 262 };
  constexpr Position right{ -34, 30, 240 };
  constexpr Position left{ 44, 34, 232 };
  constexpr Trunk    trunks[] = {
       { { 0, 22, 420 }, carina, 8.5, 8.5 },
       { carina, right, 7.0, 6.5 },
       { carina, left, 6.5, 6.0 },
       { right, { -48, 28, 248 }, 5.0, 4.0 },
       { right, { -44, 26, 224 }, 5.5, 5.0 },
       { { -44, 26, 224 }, { -52, 14, 212 }, 4.0, 3.2 },
       { { -44, 26, 224 }, { -50, 38, 212 }, 4.5, 4.0 },
       { left, { 52, 24, 238 }, 5.0, 4.0 },
       { left, { 50, 46, 220 }, 5.0, 4.0 },
  };
  constexpr Position roots[] = {
    { -48, 28, 248 }, { -52, 14, 212 }, { -50, 38, 212 }, { 52, 24, 238 }, { 50, 46, 220 }
  };
  return PlanOf(trunks, roots, spacing, tipRadius);
}

std::vector<TaperedTube>
GrowTrees(const PhantomSolid & lungs, const TreePlan & plan, unsigned seed, unsigned kind)
{
  constexpr double         toSurface = 4.0; // mm, distance of the tips from pleura and fissures
  std::vector<TaperedTube> tubes = plan.trunks;
  for (int lobe = 0; lobe < Lobes::count; ++lobe)
  {
    PhantomRandom random = RandomOf(seed, Stream::Trees, 8 * kind + static_cast<unsigned>(lobe));
    const auto    targets =
      ScatteredPoints(Lobes::Lobe(lungs, lobe), lowCorner, highCorner, plan.spacing, toSurface, random);
    GrowTree(plan.roots[static_cast<std::size_t>(lobe)], targets, plan.tipRadius, random, tubes);
  }
  return tubes;
}

std::vector<TaperedTube>
WithWalls(std::vector<TaperedTube> tubes)
{
  constexpr double thinnestWall = 0.4; // mm
  constexpr double wallOfRadius = 0.13;
  for (auto & tube : tubes)
  {
    tube.fromRadius += thinnestWall + wallOfRadius * tube.fromRadius;
    tube.toRadius += thinnestWall + wallOfRadius * tube.toRadius;
  }
  return tubes;
}

// Holes of emphysema, mostly in the upper lobes, and a few subpleural bullae.
PhantomSolid
Holes(const PhantomSolid & lungs, unsigned seed)
{
  constexpr double         holeSpacing = 9.0;     // mm
  constexpr double         holeDepth = 1.0;       // mm; minimum distance of the centers from the pleura
  constexpr double         smallestHole = 0.8;    // mm, radius
  constexpr double         mostGrowth = 5.2;      // mm; added to the radius of the largest holes
  constexpr double         bullaSpacing = 42.0;   // mm
  constexpr double         lowestBulla = 240.0;   // z, mm
  constexpr double         holesReach = 3.0;      // mm; distances are exact up to this value
  constexpr double         pleuraThickness = 0.8; // mm, intact over the holes
  std::vector<TaperedTube> balls;
  const auto               add = [&](const PointType & p, double radius) { balls.push_back({ p, p, radius, radius }); };
  PhantomRandom            random = RandomOf(seed, Stream::Holes);
  for (const PointType & p : ScatteredPoints(lungs, lowCorner, highCorner, holeSpacing, holeDepth, random))
  {
    const double size = random.Uniform(0.0, 1.0);
    const double height = std::clamp((p[2] - 120.0) / 160.0, 0.25, 1.0);
    add(p, smallestHole + mostGrowth * height * size * size);
  }
  PhantomRandom bullae = RandomOf(seed, Stream::Bullae);
  for (const PointType & p : ScatteredPoints(lungs, lowCorner, highCorner, bullaSpacing, 0.0, bullae))
  {
    const double radius = bullae.Uniform(7.0, 16.0);
    if (p[2] > lowestBulla && lungs.distance(p) > -radius)
    {
      add(p, radius);
    }
  }
  return Both(ForestSolid(balls, holesReach), Grown(lungs, -pleuraThickness));
}
} // namespace

LungState
LungStateOf(const ColonPhantomParameters & parameters)
{
  static const std::map<std::string, LungState> states{ { "inspiration", { -865.0, 0.0025, 0.22, 0.0, false } },
                                                        { "quietBreathing", { -765.0, 0.0038, 0.16, 20.0, false } },
                                                        { "emphysema", { -940.0, 0.0015, 0.3, -8.0, true } } };
  LungState                                     state = states.at(parameters.lungs);
  if (parameters.lungDensity != lungDensityOfState)
  {
    state.density = parameters.lungDensity;
  }
  return state;
}

std::vector<ColonStructures::Part>
MakeLungParts(const ColonAnatomy & anatomy, const VectorType & down)
{
  const auto &    p = anatomy.GetParameters();
  const LungState state = LungStateOf(p);
  const auto      lungs = LungSpace(anatomy, state.lift);
  const auto      airwayTubes = GrowTrees(lungs, Airways(), p.seed, 0);
  auto            vesselTubes = GrowTrees(lungs, Arteries(), p.seed, 1);
  const auto      veins = GrowTrees(lungs, Veins(), p.seed, 2);
  vesselTubes.insert(vesselTubes.end(), veins.begin(), veins.end());
  const auto airways = ForestSolid(airwayTubes, forestReach);
  const auto walls = ForestSolid(WithWalls(airwayTubes), forestReach);
  const auto vessels = ForestSolid(vesselTubes, forestReach);
  const auto holes = state.isEmphysema ? Holes(lungs, p.seed) : ForestSolid({}, forestReach);

  std::vector<ColonStructures::Part> parts;
  const auto add = [&](ColonStructure label, const PhantomSolid & solid, std::shared_ptr<const PhantomBody> body) {
    parts.push_back({ label, solid, std::move(body), false, true });
  };
  add(
    ColonStructure::None, lungs, std::make_shared<LungBody>(lungs, holes, Either(walls, vessels), state, p.seed, down));
  const auto first = static_cast<int>(ColonStructure::RightUpperLobe);
  for (int lobe = 0; lobe < Lobes::count; ++lobe)
  {
    add(static_cast<ColonStructure>(first + lobe), Lobes::Lobe(lungs, lobe), nullptr);
  }
  add(ColonStructure::None, holes, MakeSolidBody(holes, gasIntensity));
  add(ColonStructure::AirwayWall, walls, MakeSolidBody(walls, tissue));
  add(ColonStructure::Airway, airways, MakeSolidBody(airways, gasIntensity));
  add(ColonStructure::LungVessel, vessels, MakeSolidBody(vessels, tissue));
  return parts;
}
} // namespace shapeton
