#include "TrueFolds.h"

#include <cmath>

using namespace shapeton;

namespace
{
int
ValueOf(const CurveSet & folds, const char * name, int index)
{
  return static_cast<int>(std::lround(FindSurfaceArray(folds.cellArrays, name)->values(index, 0)));
}
} // namespace

TrueFolds::TrueFolds(const ColonAnatomy & anatomy)
  : m_Folds(anatomy.Folds()), m_Height(PointValues(m_Folds, "crestHeight", "the truth"))
{}

int
TrueFolds::NearestTo(const Eigen::Vector3d & point) const
{
  constexpr double reach = 6.0; // mm
  double           least = reach * reach;
  int              nearest = -1;
  for (std::size_t f = 0; f < m_Folds.curves.size(); ++f)
  {
    for (const int vertex : m_Folds.curves[f])
    {
      const double square = (m_Folds.V.row(vertex).transpose() - point).squaredNorm();
      if (m_Height[vertex] >= 1.0 && square < least)
      {
        least = square;
        nearest = static_cast<int>(f);
      }
    }
  }
  return nearest;
}

int
TrueFolds::NumberOf(int index) const
{
  return ValueOf(m_Folds, "fold", index);
}

int
TrueFolds::SegmentOf(int number) const
{
  for (std::size_t f = 0; f < m_Folds.curves.size(); ++f)
  {
    if (this->NumberOf(static_cast<int>(f)) == number)
    {
      return ValueOf(m_Folds, "segment", static_cast<int>(f));
    }
  }
  return 0;
}
