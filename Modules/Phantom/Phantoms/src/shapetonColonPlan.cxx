#include "shapetonColonPlan.h"

#include "shapetonColonCurve.h"
#include "shapetonColonNoise.h"
#include "shapetonDiverticulaPlan.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double c_TableStep = 2.0;      // mm
constexpr double c_AngleStep = 0.1;      // radians, of the search for a direction
constexpr double c_BumpBeyond = 4.0;     // mm of a valve without lips beyond the start of the cecum
constexpr double c_FoldFromValve = 8.0;  // mm; folds closer to lips are removed
constexpr double c_PolypFromValve = 6.0; // mm
constexpr double c_BetweenPolyps = 8.0;  // mm
constexpr double c_FreeOfPolyps = 60.0;  // mm from the anal verge, occupied by the catheter
constexpr int    c_PolypAttempts = 400;  // places tried for a polyp

double
Lookup(const std::vector<double> & table, double x)
{
  const double      t = std::clamp(x / c_TableStep, 0.0, table.size() - 1.001);
  const std::size_t i = static_cast<std::size_t>(t);
  return table[i] + (t - i) * (table[i + 1] - table[i]);
}
} // namespace

double
WrapAngle(double angle)
{
  return angle - 2 * M_PI * std::ceil((angle - M_PI) / (2 * M_PI));
}

double
AngleTowards(const ColonCurve & curve, double t, const Eigen::Vector3d & direction)
{
  double best = 0.0;
  double most = -2.0; // below every cosine
  for (double angle = -3.1; angle < M_PI; angle += c_AngleStep)
  {
    const double share = curve.Direction(t, angle).dot(direction);
    best = share > most ? angle : best;
    most = std::max(most, share);
  }
  return best;
}

double
AngleOfIleum(const ColonCurve & curve, const ValvePlan & valve)
{
  const Eigen::Vector3d middle(20.0, 0.0, 0.0);
  const double          t = valve.material / curve.GetStep();
  return AngleTowards(
    curve, t, Eigen::AngleAxisd(valve.behind, Eigen::Vector3d::UnitZ()) * (middle - curve.At(t).position));
}

ColonPlan::ColonPlan(const ColonPath & rest, const ColonPhantomParameters & parameters) : m_Length(rest.Length())
{
  for (int segment = 1; segment <= 6; ++segment)
  {
    const auto first = std::lower_bound(rest.segment.begin(), rest.segment.end(), segment);
    m_SegmentBegin.push_back(rest.material[first - rest.segment.begin()]);
  }
  m_SegmentBegin.push_back(m_Length);
  const int count = static_cast<int>(m_Length / c_TableStep) + 2;
  m_Radius = RestRadius(rest, parameters, count);
  this->PlanTaeniae(parameters.seed);
  this->PlanFolds(parameters.seed);
  this->PlanValve(rest, parameters);
  this->PlanPolyps(parameters.seed, parameters.polyps);
  diverticula = PlanDiverticula(*this, parameters.seed, parameters.diverticula);
}

// The ileum enters from the middle of the body.
void
ColonPlan::PlanValve(const ColonPath & rest, const ColonPhantomParameters & parameters)
{
  const ColonCurve curve(rest, std::vector<double>(ColonCurve::NumberOfSteps(m_Length) + 1, 0.0));
  ColonRandom      random(parameters.seed, ColonStream::Valve);
  valve.hasLips = parameters.valve == "lips";
  valve.material = m_SegmentBegin[5] + (valve.hasLips ? 0.0 : c_BumpBeyond);
  if (!valve.hasLips)
  {
    valve.angle = AngleTowards(curve, valve.material / curve.GetStep(), Eigen::Vector3d::UnitX());
    return;
  }
  valve.behind = random.Uniform(-0.4, 0.9);
  valve.angle = AngleOfIleum(curve, valve);
  valve.length = parameters.valveLength;
  valve.height = parameters.valveHeight;
  valve.thickness = random.Uniform(10.0, 15.0);
  folds.erase(std::remove_if(folds.begin(),
                             folds.end(),
                             [this](const FoldPlan & fold) {
                               return this->IsNearValve(fold.material, fold.angle, fold.halfAngle, c_FoldFromValve);
                             }),
              folds.end());
}

bool
ColonPlan::IsNearValve(double material, double angle, double halfAngle, double margin) const
{
  const double beside = (std::abs(WrapAngle(angle - valve.angle)) - halfAngle) * this->RadiusAt(valve.material);
  return valve.hasLips && std::abs(material - valve.material) < valve.thickness + margin &&
         beside < 0.5 * valve.length + margin;
}

int
ColonPlan::SegmentAt(double material) const
{
  int segment = 1;
  while (segment < 6 && material >= m_SegmentBegin[segment])
  {
    ++segment;
  }
  return segment;
}

double
ColonPlan::RadiusAt(double material) const
{
  const double t = std::clamp(material / m_Length, 0.0, 1.0) * (m_Radius.size() - 1);
  return Lookup(m_Radius, t * c_TableStep);
}

double
ColonPlan::TaeniaAngle(int taenia, double material) const
{
  return Lookup(m_Taenia[taenia], material);
}

double
ColonPlan::HaustraStrength(double material) const
{
  // The taeniae coli form one layer in the rectum and meet at the end of the cecum.
  const double rectumEnd = m_SegmentBegin[1];
  return SmoothStep(rectumEnd - 20, rectumEnd + 40, material) * SmoothStep(0, 25, m_Length - material);
}

void
ColonPlan::PlanTaeniae(unsigned seed)
{
  ColonRandom       random(seed, ColonStream::Taeniae);
  const double      start = random.Uniform(-M_PI, M_PI);
  const SmoothNoise drift(random, m_Length, 220.0);
  for (int taenia = 0; taenia < 3; ++taenia)
  {
    const SmoothNoise own(random, m_Length, 80.0);
    for (double m = 0; m < m_Length + 2 * c_TableStep; m += c_TableStep)
    {
      m_Taenia[taenia].push_back(start + taenia * 2 * M_PI / 3 + 0.6 * drift(m) + 0.1 * own(m));
    }
  }
}

FoldPlan
ColonPlan::MakeFold(double material, double angle, double halfAngle, ColonRandom & random) const
{
  FoldPlan     fold;
  const double radius = this->RadiusAt(material);
  const double wide = std::clamp((radius - 18.0) / 5.0, -2.0, 1.5);
  fold.material = material;
  fold.angle = angle;
  fold.halfAngle = halfAngle;
  // Folds are higher in wide stretches; quartiles 3.5, 6.6 and 11.4 mm.
  fold.height = std::clamp(8.3 * std::exp(0.95 * (0.5 * wide + 0.85 * random.Normal())), 1.8, 16.0);
  fold.thickness = random.Uniform(1.5, 3.0);
  fold.slant = random.Uniform(-3.0, 3.0);
  fold.bow = random.Uniform(-2.5, 4.0);
  fold.wave = random.Uniform(0.0, 1.2);
  fold.wavePhase = random.Uniform(-M_PI, M_PI);
  return fold;
}

void
ColonPlan::PlanValves(ColonRandom & random)
{
  // The transverse folds of the rectum: left, right, left.
  const double places[] = { 0.5, 0.68, 0.86 };
  for (int i = 0; i < 3; ++i)
  {
    FoldPlan fold =
      this->MakeFold(places[i] * m_SegmentBegin[1], (i % 2 == 0 ? -0.5 : 0.5) * M_PI, random.Uniform(1.2, 1.5), random);
    fold.height = random.Uniform(8.0, 12.0);
    folds.push_back(fold);
  }
}

void
ColonPlan::PlanLevel(double material, int level, ColonRandom & random)
{
  const int    segment = this->SegmentAt(material);
  const bool   isRight = segment >= 4;
  const double kind = random.Uniform();
  const int    first = std::min(2, static_cast<int>(3 * random.Uniform()));
  const auto   middleOf = [&](int row, double m) {
    const double a = this->TaeniaAngle(row, m);
    return a + 0.5 * WrapAngle(this->TaeniaAngle((row + 1) % 3, m) - a);
  };
  if (kind < (isRight ? 0.4 : 0.12))
  {
    folds.push_back(this->MakeFold(material, middleOf(first, material), random.Uniform(2.3, 2.7), random));
    return;
  }
  const bool spansTwo = kind < (isRight ? 0.7 : 0.4);
  if (spansTwo)
  {
    const double angle = this->TaeniaAngle((first + 1) % 3, material);
    folds.push_back(this->MakeFold(material, angle, random.Uniform(1.7, 2.0), random));
  }
  for (int row = 0; row < 3; ++row)
  {
    if (spansTwo && row != (first + 2) % 3)
    {
      continue;
    }
    // Neighboring rows alternate.
    const double m = material + (((row + level) % 3) - 1) * 7.0 + random.Uniform(-2.0, 2.0);
    folds.push_back(this->MakeFold(m, middleOf(row, m), random.Uniform(0.85, 1.1), random));
  }
}

void
ColonPlan::PlanFolds(unsigned seed)
{
  ColonRandom random(seed, ColonStream::Folds);
  this->PlanValves(random);
  double material = m_SegmentBegin[1] + 12.0;
  for (int level = 0; material < m_Length - 18.0; ++level)
  {
    random.Seek(level + 1);
    this->PlanLevel(material, level, random);
    material += random.Uniform(20.0, 30.0);
  }
}

bool
ColonPlan::IsClearOfFolds(const PolypPlan & polyp) const
{
  // Heads avoid folds, since folds may slide in other positions.
  const double head = polyp.kind == "pedunculated" ? 0.5 * polyp.diameter + 4.0 : 0.3 * polyp.diameter + 1.0;
  return std::all_of(folds.begin(), folds.end(), [&](const FoldPlan & fold) {
    if (polyp.fold >= 0 && &fold == &folds[polyp.fold])
    {
      return true;
    }
    const double beside = std::abs(WrapAngle(polyp.angle - fold.angle)) - fold.halfAngle;
    return std::abs(polyp.material - fold.material) > head + 3.0 || beside * this->RadiusAt(polyp.material) > head;
  });
}

bool
ColonPlan::PlacePolyp(ColonRandom & random, PolypPlan & polyp) const
{
  const bool onFold = polyp.kind != "flat" && random.Uniform() < (polyp.kind == "pedunculated" ? 0.7 : 0.4);
  if (onFold)
  {
    polyp.fold = std::min(static_cast<int>(folds.size() * random.Uniform()), static_cast<int>(folds.size()) - 1);
    const FoldPlan & fold = folds[polyp.fold];
    polyp.material = fold.material;
    polyp.angle = fold.angle + random.Uniform(-0.5, 0.5) * fold.halfAngle;
  }
  else
  {
    polyp.fold = -1;
    polyp.material = random.Uniform(c_FreeOfPolyps, m_Length - 10.0);
    polyp.angle = random.Uniform(-M_PI, M_PI);
  }
  if ((!onFold || polyp.kind == "pedunculated") && !this->IsClearOfFolds(polyp))
  {
    return false;
  }
  if (this->IsNearValve(polyp.material, polyp.angle, 0.0, 0.5 * polyp.diameter + c_PolypFromValve))
  {
    return false;
  }
  const double radius = this->RadiusAt(polyp.material);
  const double onTop = onFold ? std::min(folds[polyp.fold].height, 0.6 * radius) : 0.0;
  const bool   leavesRoom = polyp.diameter < 1.2 * radius && onTop + polyp.height + polyp.stalk < 1.1 * radius;
  return leavesRoom && std::none_of(polyps.begin(), polyps.end(), [&polyp](const PolypPlan & other) {
           return std::abs(other.material - polyp.material) < 0.5 * (other.diameter + polyp.diameter) + c_BetweenPolyps;
         });
}

void
ColonPlan::PlanPolyps(unsigned seed, int count)
{
  ColonRandom random(seed, ColonStream::Polyps);
  for (int i = 0; i < count; ++i)
  {
    PolypPlan polyp{};
    // Redraws unsuitable positions, finally with a smaller polyp.
    bool isPlaced = false;
    for (int attempt = 0; attempt < c_PolypAttempts && !isPlaced; ++attempt)
    {
      random.Seek(1000 * i + attempt);
      const double kind = random.Uniform();
      const double size = random.Uniform();
      const double shrink = std::pow(0.995, attempt);
      polyp.kind = kind < 0.5 ? "sessile" : (kind < 0.75 ? "pedunculated" : "flat");
      polyp.diameter = (polyp.kind == "sessile" ? 3.0 * std::pow(10.0, size) : 7.0 * std::pow(3.0, size)) * shrink;
      polyp.diameter = std::max(3.0, polyp.diameter);
      polyp.stalk = 0.0;
      polyp.height = polyp.diameter * random.Uniform(0.45, 0.6);
      if (polyp.kind == "pedunculated")
      {
        polyp.height = polyp.diameter;
        polyp.stalk = random.Uniform(4.0, 9.0);
        polyp.stalkRadius = random.Uniform(1.5, 2.5);
      }
      if (polyp.kind == "flat")
      {
        polyp.height = std::min(random.Uniform(2.0, 3.0), 0.4 * polyp.diameter);
      }
      isPlaced = this->PlacePolyp(random, polyp);
    }
    if (isPlaced)
    {
      polyps.push_back(polyp);
    }
  }
}
} // namespace shapeton
