#include "shapetonColonPlan.h"

#include "shapetonColonNoise.h"
#include "shapetonPi.h"

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
constexpr double c_CecumOfPolyps = 10.0; // mm from the end of the cecum without centers of polyps
constexpr int    c_PolypAttempts = 400;  // places tried for a polyp

// Haustra fade out over these lengths (mm) before and behind the end of the rectum, and toward the end of the cecum.
constexpr double c_RectumWithHaustra = 20.0;
constexpr double c_SigmoidWithoutHaustra = 40.0;
constexpr double c_CecumWithoutHaustra = 25.0;

// Angles (radians) by which the taeniae turn along the colon, jointly and individually.
constexpr double c_CommonDrift = 0.6;
constexpr double c_OwnDrift = 0.1;

// Folds: lengths in mm, half angles in radians. The logarithm of the height varies by c_HeightDeviation.
constexpr double     c_MiddleHeight = 8.3;
constexpr double     c_HeightDeviation = 0.95;
constexpr double     c_OwnHeight = 0.85; // weight of the random part of the height
constexpr double     c_LowestFold = 1.8;
constexpr double     c_HighestFoldAtRest = 16.0;
constexpr DrawnRange c_FoldThickness{ 1.5, 3.0 };
constexpr DrawnRange c_FoldSlant{ -3.0, 3.0 };
constexpr DrawnRange c_FoldBow{ -2.5, 4.0 };
constexpr DrawnRange c_FoldWave{ 0.0, 1.2 };
constexpr DrawnRange c_RectalHalfAngle{ 1.2, 1.5 };
constexpr DrawnRange c_RectalHeight{ 8.0, 12.0 };
constexpr DrawnRange c_RingHalfAngle{ 2.3, 2.7 };
constexpr DrawnRange c_TwoRowsHalfAngle{ 1.7, 2.0 };
constexpr DrawnRange c_OneRowHalfAngle{ 0.85, 1.1 };
constexpr DrawnRange c_BetweenLevels{ 20.0, 30.0 };
constexpr double     c_FirstFold = 12.0; // behind the rectum
constexpr double     c_LastFold = 18.0;  // before the end of the cecum

/** Upper limits of the random number that selects the kind of a level of folds; above both, there is one fold in each
 * row. */
struct LevelKinds
{
  double ring;    ///< a fold nearly around the colon
  double twoRows; ///< a fold over two rows and one in the third
};
constexpr LevelKinds c_RightLevels{ 0.4, 0.7 };
constexpr LevelKinds c_LeftLevels{ 0.12, 0.4 };

// The valve.
constexpr DrawnRange c_IleumBehind{ -0.4, 0.9 };   // radians
constexpr DrawnRange c_LipThickness{ 10.0, 15.0 }; // mm

// Polyps: lengths in mm. Diameters are drawn uniformly on a logarithmic scale, from the smallest one to `ratio` times
// that.
constexpr double     c_SessileShare = 0.5;
constexpr double     c_StalkedShare = 0.75; // with the sessile ones
constexpr double     c_SmallestPolyp = 3.0;
constexpr double     c_SessileRatio = 10.0;
constexpr double     c_SmallestOther = 7.0; // with a stalk, or flat
constexpr double     c_OtherRatio = 3.0;
constexpr DrawnRange c_SessileHeight{ 0.45, 0.6 }; // of the diameter
constexpr DrawnRange c_Stalk{ 4.0, 9.0 };
constexpr DrawnRange c_StalkRadius{ 1.5, 2.5 };
constexpr DrawnRange c_FlatHeight{ 2.0, 3.0 };
constexpr double     c_HighestFlat = 0.4; // of the diameter

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
  return angle - TwoPi * std::ceil((angle - Pi) / TwoPi);
}

double
AngleTowards(const ColonCurve & curve, double t, const Eigen::Vector3d & direction)
{
  double best = 0.0;
  double most = -2.0; // below every cosine
  for (double angle = -3.1; angle < Pi; angle += c_AngleStep)
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
  this->PlanTaeniae(rest, parameters);
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
  valve.behind = random.Uniform(c_IleumBehind);
  valve.angle = AngleOfIleum(curve, valve);
  valve.length = parameters.valveLength;
  valve.height = parameters.valveHeight;
  valve.thickness = random.Uniform(c_LipThickness);
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
  return SmoothStep(rectumEnd - c_RectumWithHaustra, rectumEnd + c_SigmoidWithoutHaustra, material) *
         SmoothStep(0, c_CecumWithoutHaustra, m_Length - material);
}

void
ColonPlan::PlanTaeniae(const ColonPath & rest, const ColonPhantomParameters & parameters)
{
  ColonRandom random(parameters.seed, ColonStream::Taeniae);
  m_StartOfTaeniae = random.Uniform(-Pi, Pi);
  if (parameters.anatomicalTaeniae)
  {
    // The valve is medial, a quarter of a turn from the libera.
    const ColonCurve curve(rest, std::vector<double>(ColonCurve::NumberOfSteps(m_Length) + 1, 0.0));
    m_StartOfTaeniae = AngleTowards(curve, m_SegmentBegin[5] / curve.GetStep(), Eigen::Vector3d::UnitX()) + 0.5 * Pi;
  }
  const SmoothNoise drift(random, m_Length, 220.0);
  for (int taenia = 0; taenia < 3; ++taenia)
  {
    const SmoothNoise own(random, m_Length, 80.0);
    for (double m = 0; m < m_Length + 2 * c_TableStep; m += c_TableStep)
    {
      m_Taenia[taenia].push_back(m_StartOfTaeniae + taenia * TwoPi / 3 + c_CommonDrift * drift(m) +
                                 c_OwnDrift * own(m));
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
  fold.height = std::clamp(c_MiddleHeight * std::exp(c_HeightDeviation * (0.5 * wide + c_OwnHeight * random.Normal())),
                           c_LowestFold,
                           c_HighestFoldAtRest);
  fold.thickness = random.Uniform(c_FoldThickness);
  fold.slant = random.Uniform(c_FoldSlant);
  fold.bow = random.Uniform(c_FoldBow);
  fold.wave = random.Uniform(c_FoldWave);
  fold.wavePhase = random.Uniform(-Pi, Pi);
  return fold;
}

void
ColonPlan::PlanValves(ColonRandom & random)
{
  // The transverse folds of the rectum: left, right, left.
  const double places[] = { 0.5, 0.68, 0.86 };
  for (int i = 0; i < 3; ++i)
  {
    FoldPlan fold = this->MakeFold(
      places[i] * m_SegmentBegin[1], (i % 2 == 0 ? -0.5 : 0.5) * Pi, random.Uniform(c_RectalHalfAngle), random);
    fold.height = random.Uniform(c_RectalHeight);
    folds.push_back(fold);
  }
}

void
ColonPlan::PlanLevel(double material, int level, ColonRandom & random)
{
  const int    segment = this->SegmentAt(material);
  const auto & kinds = segment >= 4 ? c_RightLevels : c_LeftLevels;
  const double kind = random.Uniform();
  const int    first = std::min(2, static_cast<int>(3 * random.Uniform()));
  const auto   middleOf = [&](int row, double m) {
    const double a = this->TaeniaAngle(row, m);
    return a + 0.5 * WrapAngle(this->TaeniaAngle((row + 1) % 3, m) - a);
  };
  if (kind < kinds.ring)
  {
    folds.push_back(this->MakeFold(material, middleOf(first, material), random.Uniform(c_RingHalfAngle), random));
    return;
  }
  const bool spansTwo = kind < kinds.twoRows;
  if (spansTwo)
  {
    const double angle = this->TaeniaAngle((first + 1) % 3, material);
    folds.push_back(this->MakeFold(material, angle, random.Uniform(c_TwoRowsHalfAngle), random));
  }
  for (int row = 0; row < 3; ++row)
  {
    if (spansTwo && row != (first + 2) % 3)
    {
      continue;
    }
    // Neighboring rows alternate.
    const double m = material + (((row + level) % 3) - 1) * 7.0 + random.Uniform(-2.0, 2.0);
    folds.push_back(this->MakeFold(m, middleOf(row, m), random.Uniform(c_OneRowHalfAngle), random));
  }
}

void
ColonPlan::PlanFolds(unsigned seed)
{
  ColonRandom random(seed, ColonStream::Folds);
  this->PlanValves(random);
  double material = m_SegmentBegin[1] + c_FirstFold;
  for (int level = 0; material < m_Length - c_LastFold; ++level)
  {
    random.Seek(level + 1);
    this->PlanLevel(material, level, random);
    material += random.Uniform(c_BetweenLevels);
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
    polyp.material = random.Uniform(c_FreeOfPolyps, m_Length - c_CecumOfPolyps);
    polyp.angle = random.Uniform(-Pi, Pi);
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
      polyp.kind = kind < c_SessileShare ? "sessile" : (kind < c_StalkedShare ? "pedunculated" : "flat");
      polyp.diameter = (polyp.kind == "sessile" ? c_SmallestPolyp * std::pow(c_SessileRatio, size)
                                                : c_SmallestOther * std::pow(c_OtherRatio, size)) *
                       shrink;
      polyp.diameter = std::max(c_SmallestPolyp, polyp.diameter);
      polyp.stalk = 0.0;
      polyp.height = polyp.diameter * random.Uniform(c_SessileHeight);
      if (polyp.kind == "pedunculated")
      {
        polyp.height = polyp.diameter;
        polyp.stalk = random.Uniform(c_Stalk);
        polyp.stalkRadius = random.Uniform(c_StalkRadius);
      }
      if (polyp.kind == "flat")
      {
        polyp.height = std::min(random.Uniform(c_FlatHeight), c_HighestFlat * polyp.diameter);
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
