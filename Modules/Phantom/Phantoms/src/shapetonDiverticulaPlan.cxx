#include "shapetonColonPlan.h"

#include "shapetonColonNoise.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
// Relative probability per mm of each segment, rectum to cecum.
constexpr double c_Frequency[] = { 0.0, 1.0, 0.8, 0.08, 0.12, 0.0 };
constexpr double c_RowShare = 0.7;      // probability of continuing a row
constexpr double c_NarrowestTube = 8.0; // mm, radius
constexpr double c_FoldSlide = 4.0;     // mm; maximum shift of folds in a position
constexpr double c_Rim = 1.5;           // mm of wall without folds around a mouth
constexpr double c_BetweenSacs = 3.0;   // mm
constexpr double c_FromValve = 50.0;    // mm along the colon
constexpr double c_StoolShare = 0.25;
constexpr int    c_Attempts = 400;
constexpr double c_SmallestDiameter = 3.0; // mm
constexpr double c_DiameterRange = 7.0;    // mm
constexpr double c_FavorSmall = 1.5;       // exponent of the drawn number; above 1 favors small sacs
constexpr double c_FoldEnd = 1.3;          // half angles of a fold from its middle

constexpr DrawnRange c_Neck{ 1.5, 4.0 };       // mm, inner diameter
constexpr DrawnRange c_NeckLength{ 2.0, 3.0 }; // mm
constexpr DrawnRange c_AlongRow{ 8.0, 30.0 };  // mm from one diverticulum of a row to the next

/** A row of diverticula. */
struct Row
{
  double material; ///< of the last diverticulum
  int    taenia;
  double side; ///< side of the taenia, -1 or 1
};

class DiverticulaPlanner
{
public:
  DiverticulaPlanner(const ColonPlan & plan, unsigned seed) : m_Plan(plan), m_Random(seed, ColonStream::Diverticula) {}

  std::vector<DiverticulumPlan>
  Plan(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      bool isPlaced = false;
      for (int attempt = 0; attempt < c_Attempts && !isPlaced; ++attempt)
      {
        m_Random.Seek(1000 * i + attempt);
        isPlaced = this->Try();
      }
    }
    return m_Diverticula;
  }

private:
  bool
  Try()
  {
    const bool   goesOn = m_Random.Uniform() < c_RowShare && !m_Diverticula.empty();
    const Row    row = goesOn ? this->NextInRow() : this->NewRow();
    const double beside = m_Random.Uniform(5.0, 9.0);
    if (!(row.material > 0.0 && row.material < m_Plan.Length()))
    {
      return false;
    }
    DiverticulumPlan one;
    one.material = row.material;
    one.angle =
      WrapAngle(m_Plan.TaeniaAngle(row.taenia, row.material) + row.side * beside / m_Plan.RadiusAt(row.material));
    one.diameter = c_SmallestDiameter + c_DiameterRange * std::pow(m_Random.Uniform(), c_FavorSmall);
    one.neck = std::min(m_Random.Uniform(c_Neck), 0.5 * one.diameter);
    one.neckLength = m_Random.Uniform(c_NeckLength);
    const bool   holdsStool = m_Random.Uniform() < c_StoolShare;
    const double intensity = m_Random.Uniform(200.0, 650.0);
    one.stool = holdsStool ? intensity : 0.0;
    if (!this->IsSuitable(one))
    {
      return false;
    }
    m_Diverticula.push_back(one);
    m_Row = row;
    return true;
  }

  Row
  NextInRow()
  {
    Row row = m_Row;
    row.material += (m_Random.Uniform() < 0.5 ? -1.0 : 1.0) * m_Random.Uniform(c_AlongRow);
    return row;
  }

  Row
  NewRow()
  {
    const double material = m_Random.Uniform(0.0, m_Plan.Length());
    const bool   isChosen = m_Random.Uniform() < c_Frequency[m_Plan.SegmentAt(material) - 1];
    const int    taenia = std::min(2, static_cast<int>(3 * m_Random.Uniform()));
    const double side = m_Random.Uniform() < 0.5 ? -1.0 : 1.0;
    return { isChosen ? material : -1.0, taenia, side };
  }

  bool
  IsSuitable(const DiverticulumPlan & one) const
  {
    return c_Frequency[m_Plan.SegmentAt(one.material) - 1] > 0.0 && m_Plan.RadiusAt(one.material) > c_NarrowestTube &&
           std::abs(one.material - m_Plan.valve.material) > c_FromValve && this->IsClearOfFolds(one) &&
           this->IsClearOfPolyps(one) && this->IsClearOfOthers(one);
  }

  bool
  IsClearOfFolds(const DiverticulumPlan & one) const
  {
    return std::none_of(m_Plan.folds.begin(), m_Plan.folds.end(), [&one](const FoldPlan & fold) {
      const double u = WrapAngle(one.angle - fold.angle) / fold.halfAngle;
      const double at = fold.material + 0.5 * fold.slant * u + fold.bow * u * u;
      const double room = 0.5 * (fold.thickness + one.neck) + fold.wave + c_FoldSlide + c_Rim;
      return std::abs(u) < c_FoldEnd && std::abs(one.material - at) < room;
    });
  }

  // Distance along the wall.
  double
  Between(double material, double angle, const DiverticulumPlan & one) const
  {
    return std::hypot(material - one.material, WrapAngle(angle - one.angle) * m_Plan.RadiusAt(one.material));
  }

  bool
  IsClearOfPolyps(const DiverticulumPlan & one) const
  {
    return std::none_of(m_Plan.polyps.begin(), m_Plan.polyps.end(), [&](const PolypPlan & polyp) {
      const double room = 0.5 * (polyp.diameter + one.neck) + (polyp.fold >= 0 ? c_FoldSlide : 0.0) + 2.0 * c_Rim;
      return this->Between(polyp.material, polyp.angle, one) < room;
    });
  }

  bool
  IsClearOfOthers(const DiverticulumPlan & one) const
  {
    return std::none_of(m_Diverticula.begin(), m_Diverticula.end(), [&](const DiverticulumPlan & other) {
      return this->Between(other.material, other.angle, one) < 0.5 * (other.diameter + one.diameter) + c_BetweenSacs;
    });
  }

  const ColonPlan &             m_Plan;
  ColonRandom                   m_Random;
  Row                           m_Row{};
  std::vector<DiverticulumPlan> m_Diverticula;
};
} // namespace

std::vector<DiverticulumPlan>
PlanDiverticula(const ColonPlan & plan, unsigned seed, int count)
{
  return DiverticulaPlanner(plan, seed).Plan(count);
}
} // namespace shapeton
