#include "shapetonColonRelief.h"

#include "shapetonColonNoise.h"
#include "shapetonCubicBSpline.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int    c_RowsPerStep = 2;          // of the curve
constexpr double c_CollapseEnd = 15.0;       // mm
constexpr double c_ClosedCanal = 20.0;       // mm of the anal canal without a catheter
constexpr double c_HighestFold = 0.6;        // of the radius, so that no fold blocks the lumen
constexpr double c_FoldNeighborhood = 16;    // mm along the colon
constexpr double c_LongestChord = 44.0;      // mm along the colon; more distant stretches are separated by a septum
constexpr double c_ChordStep = 4.0;          // mm
constexpr double c_RoughnessLimit = 2.2;     // bound of the random coefficients of the roughness
constexpr double c_BetweenCollapses = 120.0; // mm along the colon
constexpr double c_FixedFolds = 120.0;       // mm from the anal verge; folds up to here do not slide
constexpr double c_FreeFolds = 200.0;        // mm from the anal verge; folds from here slide by the full amount
constexpr double c_WaistEnd = 1.3;           // half angles of a fold from its middle
constexpr double c_PlanStep = 10.0;          // mm, of the list of folds near a place

// Changes in radius between the folds and the taeniae, as fractions of the radius, where the haustra are fully formed.
constexpr double c_HaustraBulge = 0.2;
constexpr double c_HaustraInset = 0.06; // everywhere
constexpr double c_TaeniaInset = 0.05;

// Roughness of the wall: knots 4 mm apart, so wavelengths of at least 8 mm.
class Roughness
{
public:
  Roughness(unsigned seed, double length)
    : m_Rows(static_cast<int>(length / c_Knot) + 4), m_Values(std::size_t(m_Rows) * c_Columns)
  {
    ColonRandom random(seed, ColonStream::Roughness);
    for (float & value : m_Values)
    {
      value = static_cast<float>(random.Uniform(-c_RoughnessLimit, c_RoughnessLimit));
    }
  }

  double
  At(double material, double angle) const
  {
    const double       row = material / c_Knot;
    const double       column = (angle / TwoPi + 2.0) * c_Columns;
    const CubicWeights x(row - std::floor(row)), y(column - std::floor(column));
    double             sum = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      const float * values = &m_Values[std::size_t(std::min(static_cast<int>(row) + i, m_Rows - 1)) * c_Columns];
      for (int k = 0; k < 4; ++k)
      {
        sum += x.value[i] * y.value[k] * values[(static_cast<int>(column) + k) % c_Columns];
      }
    }
    return sum;
  }

private:
  static constexpr double c_Knot = 4.0;   // mm along the colon
  static constexpr int    c_Columns = 32; // around the colon
  int                     m_Rows;
  std::vector<float>      m_Values;
};

/** Distances from a point of the curve to its neighbors on one side. */
class Chords
{
public:
  Chords(const ColonCurve & curve, double t, double longest)
  {
    const Eigen::Vector3d at = curve.At(t).position;
    for (double off = c_ChordStep; off <= longest; off += c_ChordStep)
    {
      for (const double other : { t - off / curve.GetStep(), t + off / curve.GetStep() })
      {
        if (other >= 0.0 && other <= curve.GetNumberOfSteps())
        {
          const Eigen::Vector3d chord = curve.At(other).position - at;
          m_Chords.push_back(2.0 / chord.squaredNorm() * chord);
        }
      }
    }
  }

  // Inverse distance (1/mm) in this direction beyond which points are closer to a neighbor; equals the curvature for
  // short chords.
  double
  BendTowards(const Eigen::Vector3d & direction) const
  {
    double bend = 0.0;
    for (const Eigen::Vector3d & chord : m_Chords)
    {
      bend = std::max(bend, chord.dot(direction));
    }
    return bend;
  }

private:
  std::vector<Eigen::Vector3d> m_Chords;
};
} // namespace

bool
FoldCourse::At(double u, ReliefValue & tValue, ReliefValue & crestValue) const
{
  const double x = (u / End + 1.0) * 0.5 * Knots;
  if (!(x >= 0 && x < Knots))
  {
    return false;
  }
  const int          i = static_cast<int>(x);
  const CubicWeights w(x - i);
  tValue = crestValue = { 0, 0, 0 };
  for (int k = 0; k < 4; ++k)
  {
    tValue.value += w.value[k] * t[i + k];
    tValue.byAngle += w.first[k] * t[i + k];
    crestValue.value += w.value[k] * crest[i + k];
    crestValue.byAngle += w.first[k] * crest[i + k];
  }
  const double perAngle = 0.5 * Knots / (End * halfAngle);
  tValue.byAngle *= perAngle;
  crestValue.byAngle *= perAngle;
  return true;
}

std::vector<double>
ColonTwist(const ColonPlan & plan, const ColonPhantomParameters & parameters)
{
  const int           steps = ColonCurve::NumberOfSteps(plan.Length());
  ColonRandom         random(parameters.seed, ColonStream::Torsion, PositionNumber(parameters.position));
  const SmoothNoise   noise(random, plan.Length(), 200.0);
  std::vector<double> twist;
  for (int k = 0; k <= steps; ++k)
  {
    twist.push_back(parameters.torsion * Pi / 180.0 * std::clamp(noise(k * plan.Length() / steps), -1.0, 1.0));
  }
  return twist;
}

ColonRelief::ColonRelief(const ColonPlan & plan, const ColonPhantomParameters & parameters, const ColonCurve * curve)
  : m_Steps(ColonCurve::NumberOfSteps(plan.Length()))
  , m_Step(plan.Length() / m_Steps)
  , m_Rows(c_RowsPerStep * m_Steps + 1)
{
  this->FillCollapse(plan, parameters);
  this->FillBase(plan, parameters);
  const std::vector<double> places = this->FoldPlaces(plan, parameters);
  this->FillTable(plan, places, parameters);
  if (curve)
  {
    this->RelieveBends(*curve, KeepsPublishedVoxels(parameters) ? 0.0 : c_LongestChord);
  }
  this->SumUpRows();
  this->LayFolds(plan, places, parameters);
}

void
ColonRelief::FillCollapse(const ColonPlan & plan, const ColonPhantomParameters & parameters)
{
  m_Collapse.assign(m_Steps + 1, 0.0);
  if (parameters.catheter == "none")
  {
    for (int k = 0; k <= m_Steps; ++k)
    {
      m_Collapse[k] = SmoothStep(-c_ClosedCanal - c_CollapseEnd, -c_ClosedCanal, -k * m_Step);
    }
  }
  ColonRandom random(parameters.seed, ColonStream::Collapse, PositionNumber(parameters.position));
  struct Stretch
  {
    double begin;
    double end;
  };
  std::vector<Stretch> stretches;
  for (int attempt = 0; attempt < 1000 && static_cast<int>(stretches.size()) < parameters.collapsed; ++attempt)
  {
    const double  middle = random.Uniform(0.0, plan.Length());
    const double  length = random.Uniform(40.0, 120.0);
    const Stretch s{ middle - 0.5 * length, middle + 0.5 * length };
    const int     first = plan.SegmentAt(s.begin - 30.0);
    const int     last = plan.SegmentAt(s.end + 30.0);
    const bool    isApart = std::all_of(stretches.begin(), stretches.end(), [&s](const Stretch & other) {
      return s.begin > other.end + c_BetweenCollapses || s.end < other.begin - c_BetweenCollapses;
    });
    if (first >= 2 && last <= 4 && isApart)
    {
      stretches.push_back(s);
      for (int k = 0; k <= m_Steps; ++k)
      {
        const double m = k * m_Step;
        m_Collapse[k] =
          std::max(m_Collapse[k],
                   SmoothStep(s.begin - c_CollapseEnd, s.begin, m) * SmoothStep(-s.end - c_CollapseEnd, -s.end, -m));
      }
    }
  }
}

void
ColonRelief::FillBase(const ColonPlan & plan, const ColonPhantomParameters & parameters)
{
  ColonRandom       random(parameters.seed, ColonStream::Distension, PositionNumber(parameters.position));
  const SmoothNoise noise(random, plan.Length(), 110.0);
  for (int row = 0; row < m_Rows; ++row)
  {
    const double m = row * m_Step / c_RowsPerStep;
    const double free = SmoothStep(25.0, 60.0, m);
    const double factor = parameters.distension * (1.0 + 0.15 * std::clamp(noise(m), -1.0, 1.0));
    const double collapse = this->CollapseAt(row / double(c_RowsPerStep));
    const double radius = plan.RadiusAt(m) * (1.0 + free * (factor - 1.0));
    m_Base.push_back((1.0 - collapse) * radius - 3.0 * collapse);
  }
}

double
ColonRelief::CollapseAt(double t) const
{
  const int i = std::clamp(static_cast<int>(t), 0, m_Steps - 1);
  return m_Collapse[i] + (t - i) * (m_Collapse[i + 1] - m_Collapse[i]);
}

std::vector<double>
ColonRelief::FoldPlaces(const ColonPlan & plan, const ColonPhantomParameters & parameters) const
{
  ColonRandom         random(parameters.seed, ColonStream::FoldSlide, PositionNumber(parameters.position));
  const SmoothNoise   together(random, plan.Length(), 90.0);
  std::vector<double> places;
  for (std::size_t i = 0; i < plan.folds.size(); ++i)
  {
    random.Seek(static_cast<std::uint32_t>(i + 1));
    const double m = plan.folds[i].material;
    const double slide = 0.75 * std::clamp(together(m), -1.0, 1.0) + random.Uniform(-0.25, 0.25);
    // The rectal valves are fixed.
    places.push_back(m + SmoothStep(c_FixedFolds, c_FreeFolds, m) * parameters.foldSlide * slide);
  }
  return places;
}

// 1 at the foot of a fold, 0 between folds.
double
ColonRelief::Waist(const ColonPlan & plan, const std::vector<double> & places, double material, double angle) const
{
  double waist = 0.0;
  for (int i : m_PlansNear[static_cast<std::size_t>(material / c_PlanStep)])
  {
    const FoldPlan & fold = plan.folds[i];
    const double     u = WrapAngle(angle - fold.angle) / fold.halfAngle;
    if (std::abs(u) < c_WaistEnd)
    {
      const double x = (material - places[i] - 0.5 * fold.slant * u - fold.bow * u * u) / 8.0;
      const double strength = std::min(1.0, 0.3 + fold.height / 7.0) * SmoothStep(-c_WaistEnd, -0.8, -std::abs(u));
      waist = std::max(waist, strength * std::exp(-x * x));
    }
  }
  return waist;
}

void
ColonRelief::FillTable(const ColonPlan &              plan,
                       const std::vector<double> &    places,
                       const ColonPhantomParameters & parameters)
{
  m_PlansNear.resize(static_cast<std::size_t>(plan.Length() / c_PlanStep) + 1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const int middle = static_cast<int>(places[i] / c_PlanStep);
    for (int k = std::max(0, middle - 3); k <= std::min(middle + 3, static_cast<int>(m_PlansNear.size()) - 1); ++k)
    {
      m_PlansNear[k].push_back(static_cast<int>(i));
    }
  }
  const Roughness roughness(parameters.seed, plan.Length());
  m_Table.resize(std::size_t(m_Rows + 2) * Angles);
  for (int row = 0; row < m_Rows; ++row)
  {
    const double m = row * m_Step / c_RowsPerStep;
    const double base = m_Base[row];
    // Both ends are smooth hemispheres.
    const double formed = SmoothStep(6.0, 40.0, m) * SmoothStep(4.0, 24.0, plan.Length() - m);
    const double haustra = formed * plan.HaustraStrength(m) * std::max(0.0, base);
    const double rough = formed * parameters.roughness * std::clamp(base / 12.0, 0.0, 1.0);
    for (int k = 0; k < Angles; ++k)
    {
      const double angle = WrapAngle(TwoPi * k / Angles);
      double       band = 0.0;
      for (int taenia = 0; taenia < 3; ++taenia)
      {
        const double off = base * WrapAngle(angle - plan.TaeniaAngle(taenia, m)) / 4.5;
        band = std::max(band, std::exp(-off * off));
      }
      const double bulge = (1.0 - band) * (1.0 - this->Waist(plan, places, m, angle));
      m_Table[std::size_t(row + 1) * Angles + k] =
        static_cast<float>(base + haustra * (c_HaustraBulge * bulge - c_HaustraInset - c_TaeniaInset * band) +
                           rough * roughness.At(m, angle));
    }
  }
}

// The wall on the inside of a bend must be closer than the center of curvature, to avoid self-intersection. Within
// `longestChord` it must also be closer than the point where the tube touches itself, to avoid a bridge of tissue.
void
ColonRelief::RelieveBends(const ColonCurve & curve, double longestChord)
{
  constexpr double straight = 0.6;
  constexpr double most = 0.9;
  for (int row = 0; row < m_Rows; ++row)
  {
    const double            t = row / double(c_RowsPerStep);
    const ColonCurve::Frame frame = curve.At(t);
    const Chords            chords(curve, t, longestChord);
    for (int k = 0; k < Angles; ++k)
    {
      float &               radius = m_Table[std::size_t(row + 1) * Angles + k];
      const Eigen::Vector3d direction = curve.Direction(t, WrapAngle(TwoPi * k / Angles));
      const double          bend =
        std::max(direction.dot(frame.second) / frame.first.squaredNorm(), chords.BendTowards(direction));
      const double share = radius * bend;
      if (share > straight)
      {
        const double range = most - straight;
        radius = static_cast<float>((straight + range * std::tanh((share - straight) / range)) / bend);
      }
    }
  }
}

void
ColonRelief::SumUpRows()
{
  std::copy_n(m_Table.begin() + Angles, Angles, m_Table.begin());
  std::copy_n(m_Table.end() - 2 * Angles, Angles, m_Table.end() - Angles);
  for (int row = 0; row < m_Rows; ++row)
  {
    const float * values = &m_Table[std::size_t(row + 1) * Angles];
    double        sum = 0.0;
    for (int k = 0; k < Angles; ++k)
    {
      sum += values[k];
    }
    m_Mean.push_back(sum / Angles);
    m_Largest.push_back(*std::max_element(values, values + Angles));
  }
}

void
ColonRelief::LayFolds(const ColonPlan &              plan,
                      const std::vector<double> &    places,
                      const ColonPhantomParameters & parameters)
{
  m_FoldsNear.resize(m_Steps + 1);
  ColonRandom random(parameters.seed, ColonStream::FoldFlattening, PositionNumber(parameters.position));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const FoldPlan & fold = plan.folds[i];
    FoldCourse       course;
    random.Seek(static_cast<std::uint32_t>(i));
    course.isFlattened = random.Uniform() < parameters.flattenedFolds;
    course.angle = fold.angle;
    course.halfAngle = fold.halfAngle;
    course.halfThickness = 0.5 * fold.thickness;
    course.height = 0.0;
    double low = 1e9;
    double high = -1e9;
    for (int k = 0; k < FoldCourse::Knots + 3; ++k)
    {
      const double u = FoldCourse::End * (2.0 * (k - 1) / FoldCourse::Knots - 1.0);
      const double angle = WrapAngle(fold.angle + u * fold.halfAngle);
      const double m =
        std::clamp(places[i] + 0.5 * fold.slant * u + fold.bow * u * u + fold.wave * std::sin(3.0 * u + fold.wavePhase),
                   0.0,
                   plan.Length());
      const double radius = this->RadiusAt(m / m_Step, angle).value;
      const double highest = std::max(0.0, c_HighestFold * this->MeanRadiusAt(m / m_Step));
      const double height = std::min(fold.height, highest) * (course.isFlattened ? 0.3 : 1.0);
      // Long folds are slightly lower where they cross a taenia.
      constexpr double deepestDip = 0.3; // of the height
      double           dip = 0.0;
      for (int taenia = 0; taenia < 3; ++taenia)
      {
        const double off = radius * WrapAngle(angle - plan.TaeniaAngle(taenia, m)) / 6.0;
        dip = std::max(dip, deepestDip * std::exp(-off * off));
      }
      const double along = height * (1.0 - u * u * std::abs(u)) - (std::abs(u) > 1 ? 14 * (std::abs(u) - 1) : 0.0);
      course.t[k] = static_cast<float>(m / m_Step);
      course.crest[k] = static_cast<float>(radius - along * (along > 0 ? 1.0 - dip : 1.0));
      course.height = std::max(course.height, along * (1.0 - dip));
      low = std::min<double>(low, course.t[k]);
      high = std::max<double>(high, course.t[k]);
    }
    const double margin = c_FoldNeighborhood / m_Step;
    for (int k = std::max(0, static_cast<int>(low - margin)); k <= std::min<double>(m_Steps, high + margin); ++k)
    {
      m_FoldsNear[k].push_back(static_cast<int>(i));
    }
    m_Folds.push_back(course);
  }
}

ReliefValue
ColonRelief::RadiusAt(double t, double angle) const
{
  const double       row = t * c_RowsPerStep;
  const int          i = std::clamp(static_cast<int>(row), 0, m_Rows - 2);
  const double       column = (angle / TwoPi + 1.0) * Angles;
  const int          j = static_cast<int>(column);
  const CubicWeights x(row - i), y(column - j);
  ReliefValue        sum{ 0, 0, 0 };
  for (int a = 0; a < 4; ++a)
  {
    const float * values = &m_Table[std::size_t(std::min(i + a, m_Rows + 1)) * Angles];
    double        value = 0.0;
    double        slope = 0.0;
    for (int b = 0; b < 4; ++b)
    {
      const double v = values[(j + b - 1) % Angles];
      value += y.value[b] * v;
      slope += y.first[b] * v;
    }
    sum.value += x.value[a] * value;
    sum.byT += x.first[a] * value;
    sum.byAngle += x.value[a] * slope;
  }
  sum.byT *= c_RowsPerStep;
  sum.byAngle *= Angles / TwoPi;
  return sum;
}

double
ColonRelief::MeanRadiusAt(double t) const
{
  const double row = t * c_RowsPerStep;
  const int    i = std::clamp(static_cast<int>(row), 0, m_Rows - 2);
  return m_Mean[i] + (row - i) * (m_Mean[i + 1] - m_Mean[i]);
}

double
ColonRelief::LargestRadiusNear(int step) const
{
  double largest = 0.0;
  for (int row = std::max(0, c_RowsPerStep * step - 3); row <= std::min(m_Rows - 1, c_RowsPerStep * step + 3); ++row)
  {
    largest = std::max(largest, m_Largest[row]);
  }
  return largest;
}

const std::vector<int> &
ColonRelief::FoldsNear(double t) const
{
  return m_FoldsNear[std::clamp(static_cast<int>(t + 0.5), 0, m_Steps)];
}
} // namespace shapeton
