#include "shapetonFall.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shapeton
{
Fall::Fall(const ColonGrid & grid, const Eigen::Vector3d & gravity) : direction(gravity.normalized())
{
  const Eigen::Vector3d perMm = (grid.axes.inverse() * direction).cwiseQuotient(grid.spacing);
  step = 1.0 / perMm.cwiseAbs().maxCoeff();
  m_VoxelsPerStep = perMm * step;
  int most = 0;
  (grid.axes.transpose() * direction).cwiseAbs().minCoeff(&most);
  const Eigen::Vector3d axis = grid.axes.col(most);
  across[0] = (axis - axis.dot(direction) * direction).normalized();
  across[1] = direction.cross(across[0]);
}

LateralCells::LateralCells(const std::vector<Place> & places, double cellSize) : m_CellSize(cellSize)
{
  if (places.empty())
  {
    m_Begin.assign(1, 0);
    return;
  }
  const auto byA =
    std::minmax_element(places.begin(), places.end(), [](const Place & p, const Place & q) { return p.a < q.a; });
  const auto byB =
    std::minmax_element(places.begin(), places.end(), [](const Place & p, const Place & q) { return p.b < q.b; });
  m_Low = { { byA.first->a, byB.first->b } };
  m_Size = { { this->CellOf(byA.second->a - m_Low[0]) + 1, this->CellOf(byB.second->b - m_Low[1]) + 1 } };
  m_Begin.assign(static_cast<std::size_t>(m_Size[0]) * m_Size[1] + 1, 0);
  std::vector<std::size_t> cells(places.size());
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    cells[p] =
      this->CellOf(places[p].a - m_Low[0]) + static_cast<std::size_t>(this->CellOf(places[p].b - m_Low[1])) * m_Size[0];
    ++m_Begin[cells[p] + 1];
  }
  for (std::size_t c = 1; c < m_Begin.size(); ++c)
  {
    m_Begin[c] += m_Begin[c - 1];
  }
  m_Order.resize(places.size());
  auto next = m_Begin;
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    m_Order[next[cells[p]]++] = static_cast<int>(p);
  }
}
} // namespace shapeton
