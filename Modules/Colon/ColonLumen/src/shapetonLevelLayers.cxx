#include "shapetonLevelLayers.h"

#include <cmath>

namespace shapeton
{
namespace
{
constexpr double LevelReach = 6.0;  // mm around the flat part of a level
constexpr double UsualBlur = 0.8;   // mm, standard deviation of the scanner's
constexpr double LevelLeeway = 0.5; // mm

/** From where values leave the gas to where they reach the fluid, mm: between 31 % and 81 % of a blurred step. */
double
LayerThickness(const LumenField & field)
{
  const double smoothing = field.evidence.smoothing;
  return 1.38 * std::sqrt(UsualBlur * UsualBlur + smoothing * smoothing + field.fall.step * field.fall.step / 12.0);
}

/** The floors of the colon's levels: which places lie near one. */
class NearLevels
{
public:
  explicit NearLevels(const LumenField & field)
    : m_Field(field), m_Deepest(LayerThickness(field) + LevelLeeway), m_Cells(this->CollectPlaces(), LevelReach)
  {}

  bool
  Hold(std::size_t p) const
  {
    const Fall & fall = m_Field.fall;
    const auto   x = m_Field.grid.Position(p);
    const double a = x.dot(fall.across[0]);
    const double b = x.dot(fall.across[1]);
    const double depth = x.dot(fall.direction);
    bool         isNear = false;
    m_Cells.ForEachNear(a, b, [&](int i) {
      const double da = m_Places[i].a - a;
      const double db = m_Places[i].b - b;
      const double below = depth - m_Depths[i];
      isNear = isNear || (da * da + db * db <= LevelReach * LevelReach && below >= -LevelLeeway && below <= m_Deepest);
    });
    return isNear;
  }

private:
  const std::vector<LateralCells::Place> &
  CollectPlaces()
  {
    const Fall & fall = m_Field.fall;
    for (const auto & level : m_Field.ColonLevels())
    {
      for (const auto floor : level.floors)
      {
        const auto p = m_Field.evidence.grid.Position(floor);
        m_Places.push_back({ static_cast<float>(p.dot(fall.across[0])), static_cast<float>(p.dot(fall.across[1])) });
        const Eigen::Vector2d d = Eigen::Vector2d(m_Places.back().a, m_Places.back().b) - level.centre;
        m_Depths.push_back(static_cast<float>(level.depth + level.slope.dot(d)));
      }
    }
    return m_Places;
  }

  const LumenField &               m_Field;
  double                           m_Deepest; ///< mm below a level
  std::vector<LateralCells::Place> m_Places;
  std::vector<float>               m_Depths;
  LateralCells                     m_Cells;
};

/** Gas above and fluid below, nothing else in between, all within some steps. */
bool
IsBetween(const LumenField & field, const ClassVolume & classes, std::size_t p, int steps)
{
  const auto v = field.grid.Voxel(p);
  int        up = 1;
  while (up <= steps && field.Below(v, -up) >= 0 && classes[field.Below(v, -up)] == Nothing)
  {
    ++up;
  }
  int down = 1;
  while (down <= steps && field.Below(v, down) >= 0 && classes[field.Below(v, down)] == Nothing)
  {
    ++down;
  }
  return up + down <= steps + 1 && field.Below(v, -up) >= 0 && field.Below(v, down) >= 0 &&
         classes[field.Below(v, -up)] == ColonGas && classes[field.Below(v, down)] == ColonFluid;
}
} // namespace

void
FillLevelLayers(LumenField & field)
{
  const NearLevels  levels(field);
  const double      thickness = LayerThickness(field) + 2.0 * LevelLeeway;
  const int         steps = static_cast<int>(std::ceil(thickness / field.fall.step)) + 1;
  const double      half = 0.5 * (field.evidence.thresholds.gas + field.evidence.thresholds.fluid);
  const ClassVolume before = field.classes;
  ParallelFor(field.grid.size[2], [&](std::size_t k) {
    for (std::size_t p = k * field.grid.stride[2]; p < (k + 1) * field.grid.stride[2]; ++p)
    {
      if (before[p] == Nothing && IsBetween(field, before, p, steps) && levels.Hold(p))
      {
        field.classes[p] = field.hu[p] < half ? ColonGas : ColonFluid;
      }
    }
  });
}
} // namespace shapeton
