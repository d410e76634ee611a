#include "shapetonLumenResidue.h"

#include "shapetonColonBody.h"
#include "shapetonColonDistance.h"
#include "shapetonColonNoise.h"
#include "shapetonColonPath.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr int    attempts = 60;       // chosen; bounds the time
constexpr double leastRadius = 8.0;   // mm, minimum radius of a lumen with residue
constexpr double intoWall = 0.35;     // mm; half a cell, so that no gas appears between stool and wall
constexpr double adherentShare = 0.3; // fraction of the stool that adheres to the wall in all positions
constexpr double clearOfRectum = 0.1; // fraction of the length occupied by the catheter
constexpr double offMiddle = 0.3; // sizes of the stool; gas in stool is up to this far from its middle along each axis
constexpr double deepestBubble = 30.0; // mm below the level
constexpr double mostUpward = 0.2;     // cosine; walls with bubbles face up by at most this
constexpr double foamDepth = 0.7;      // radii of the lumen between a level with foam and the centerline
constexpr double roomForFoam = 5.0;    // mm from the wall

constexpr DrawnRange lumpRadius{ 0.22, 0.34 }; // relative to the size of the stool
constexpr DrawnRange gasRadius{ 0.5, 1.1 };    // mm, of gas in stool

struct Ball
{
  Vector3d center;
  double   radius;
};

// A cluster of balls.
PhantomSolid
LumpSolid(const std::vector<Ball> & balls)
{
  Vector3d center = Vector3d::Zero();
  for (const Ball & ball : balls)
  {
    center += ball.center / static_cast<double>(balls.size());
  }
  double reach = 0.0;
  for (const Ball & ball : balls)
  {
    reach = std::max(reach, (ball.center - center).norm() + ball.radius);
  }
  return { [=](const PhantomBody::PointType & point) {
    const Vector3d p(point[0], point[1], point[2]);
    double         least = (p - center).norm() - reach;
    if (least > ColonAnatomy::Reach)
    {
      return least;
    }
    least = beyondAll;
    for (const Ball & ball : balls)
    {
      least = std::min(least, (p - ball.center).norm() - ball.radius);
    }
    return least;
  } };
}

class ResidueBuilder
{
public:
  ResidueBuilder(const ColonAnatomy & anatomy, const ColonFluid & fluid) : m_Anatomy(anatomy), m_Fluid(fluid) {}

  LumenResidue
  Build()
  {
    const ColonPhantomParameters & p = m_Anatomy.GetParameters();
    const unsigned                 position = PositionNumber(p.position);
    for (int i = 0; i < p.stool; ++i)
    {
      ColonRandom patient(p.seed, ColonStream::Stool);
      patient.Seek(i);
      const bool  isAdherent = patient.Uniform() < adherentShare;
      ColonRandom loose(p.seed, ColonStream::Stool, position);
      loose.Seek(i);
      this->AddStool(patient, isAdherent ? nullptr : &loose);
    }
    for (int i = 0; i < p.bubbles; ++i)
    {
      ColonRandom random(p.seed, ColonStream::Bubbles, position);
      random.Seek(i);
      this->AddBubble(random);
    }
    for (int i = 0; i < p.foam; ++i)
    {
      ColonRandom random(p.seed, ColonStream::Foam, position);
      random.Seek(i);
      this->AddFoam(random);
    }
    return m_Residue;
  }

private:
  void
  Paint(ColonStructure label, const PhantomSolid & solid, double intensity)
  {
    m_Residue.parts.push_back({ label,
                                WithinColon(solid, m_Anatomy, 0.0),
                                MakeSolidBody(WithinColon(solid, m_Anatomy, intoWall), intensity),
                                false });
  }

  // A point on the wall; if `loose`, at the lowest point of a section with random variation.
  ColonPlace
  PlaceOnWall(ColonRandom & random, bool isLoose) const
  {
    ColonPlace best{};
    for (int i = 0; i < attempts && best.radius < leastRadius; ++i)
    {
      const double share = random.Uniform(clearOfRectum, 0.99);
      const double angle = random.Uniform(-Pi, Pi);
      const double chance = random.Uniform(-0.7, 0.7);
      best = m_Anatomy.PlaceAt(share, angle);
      for (int k = 0; isLoose && k < 24; ++k)
      {
        const ColonPlace other = m_Anatomy.PlaceAt(share, -Pi + k * Pi / 12);
        best = -m_Fluid.Down().dot(other.inwards) > -m_Fluid.Down().dot(best.inwards) ? other : best;
      }
      best = isLoose ? m_Anatomy.PlaceAt(share, best.angle + chance) : best;
    }
    return best;
  }

  void
  AddStool(ColonRandom & patient, ColonRandom * loose)
  {
    const ColonPhantomParameters & p = m_Anatomy.GetParameters();
    const double                   kind = patient.Uniform();
    const double                   size = 4.0 * std::pow(5.0, patient.Uniform());
    const bool                     isTagged = patient.Uniform() < p.stoolTagged;
    const double                   tagged = patient.Uniform(200.0, 650.0);
    const double                   untagged = patient.Uniform(20.0, 70.0);
    const ColonPlace               place = this->PlaceOnWall(loose ? *loose : patient, loose != nullptr);
    if (place.radius < leastRadius)
    {
      return;
    }
    std::vector<Ball> balls;
    const Vector3d    middle = place.point + std::max(0.2 * size, 1.0) * place.inwards;
    for (int i = 0; i < 5; ++i)
    {
      const Vector3d off(patient.Uniform(-1, 1), patient.Uniform(-1, 1), patient.Uniform(-1, 1));
      balls.push_back({ middle + 0.25 * size * off, size * patient.Uniform(lumpRadius) });
    }
    const double intensity = isTagged ? tagged : untagged;
    this->Paint(ColonStructure::Stool, LumpSolid(balls), intensity);
    const bool isMottled = kind < 0.4 && size > 7.0;
    for (int i = 0; isMottled && i < static_cast<int>(size); ++i)
    {
      const Vector3d off(patient.Uniform(-1, 1), patient.Uniform(-1, 1), patient.Uniform(-1, 1));
      this->Paint(ColonStructure::None,
                  LumpSolid({ { middle + offMiddle * size * off, patient.Uniform(gasRadius) } }),
                  gasIntensity);
    }
    const std::string name = isMottled ? "mottled" : "plain";
    m_Residue.truth.push_back({ ColonStructure::Stool, middle, size, intensity, name });
  }

  // A point at the wall below a fluid level.
  void
  AddBubble(ColonRandom & random)
  {
    const double radius = random.Uniform(1.0, 3.5);
    for (int i = 0; i < attempts; ++i)
    {
      const ColonPlace place = m_Anatomy.PlaceAt(random.Uniform(clearOfRectum, 0.99), random.Uniform(-Pi, Pi));
      const Vector3d   middle = place.point + 0.8 * radius * place.inwards;
      const double     depth = m_Fluid.DepthBelowLevel(middle, place.arcLength);
      if (place.radius > leastRadius && depth > radius + 0.5 && depth < deepestBubble &&
          m_Fluid.Down().dot(place.inwards) > -mostUpward)
      {
        this->Paint(ColonStructure::Bubble, LumpSolid({ { middle, radius } }), gasIntensity);
        m_Residue.truth.push_back({ ColonStructure::Bubble, middle, 2.0 * radius, gasIntensity, "bubble" });
        return;
      }
    }
  }

  // A layer of small bubbles with fluid films on a level.
  void
  AddFoam(ColonRandom & random)
  {
    for (int i = 0; i < attempts; ++i)
    {
      const ColonPlace place = m_Anatomy.PlaceAt(random.Uniform(clearOfRectum, 0.99), 0.0);
      const Vector3d   center = place.point + place.radius * place.inwards;
      const double     depth = m_Fluid.DepthBelowLevel(center, place.arcLength);
      const Vector3d   level = center - depth * m_Fluid.Down();
      if (place.radius > leastRadius && std::abs(depth) < foamDepth * place.radius &&
          m_Anatomy.Evaluate(level).distance > roomForFoam)
      {
        this->PaintFoam(random, level, m_Fluid.Intensity(level + m_Fluid.Down(), place.arcLength));
        return;
      }
    }
  }

  void
  PaintFoam(ColonRandom & random, const Vector3d & level, double intensity)
  {
    const double      radius = random.Uniform(6.0, 12.0);
    const double      height = random.Uniform(2.5, 5.0);
    const Vector3d    up = -m_Fluid.Down();
    const Vector3d    across = up.unitOrthogonal();
    std::vector<Ball> films, bubbles;
    const int         count = static_cast<int>(radius * radius * height / 8.0);
    for (int i = 0; i < count; ++i)
    {
      const double   from = radius * std::sqrt(random.Uniform());
      const double   angle = random.Uniform(-Pi, Pi);
      const double   most = height * (1.0 - 0.7 * from / radius);
      const Vector3d at = level + from * (Eigen::AngleAxisd(angle, up) * across) + random.Uniform(0.0, most) * up;
      const double   size = random.Uniform(0.7, 1.6);
      films.push_back({ at, size + 0.5 });
      bubbles.push_back({ at, size });
    }
    this->Paint(ColonStructure::Foam, LumpSolid(films), intensity);
    this->Paint(ColonStructure::None, LumpSolid(bubbles), gasIntensity);
    m_Residue.truth.push_back({ ColonStructure::Foam, level + 0.5 * height * up, 2.0 * radius, intensity, "foam" });
  }

  const ColonAnatomy & m_Anatomy;
  const ColonFluid &   m_Fluid;
  LumenResidue         m_Residue;
};
} // namespace

LumenResidue
MakeLumenResidue(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  return ResidueBuilder(anatomy, fluid).Build();
}
} // namespace shapeton
