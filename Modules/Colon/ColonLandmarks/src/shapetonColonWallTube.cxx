#include "shapetonColonWallTube.h"

#include "shapetonCenterlineMatch.h"
#include "shapetonFlatSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace shapeton
{
ColonWallTube::ColonWallTube(const FlatColon & colon, const CurveSet & centerline)
{
  const SurfaceMesh & flat = colon.Surface();
  RequireSound(flat, "the flat surface");
  const Eigen::MatrixX2d uv = FlatCoordinates(flat, "the flat surface");
  m_Circumference = FlatCircumference(flat, "the flat surface");
  this->Weld(flat);
  m_Uv.resize(m_V.rows(), 2);
  for (int vertex = 0; vertex < this->NumberOfVertices(); ++vertex)
  {
    m_Uv.row(vertex) = uv.row(m_FlatOfVertex[vertex]);
  }
  this->CountTurns(flat, uv);
  this->MeasureArcLength(colon, centerline);
}

ColonWallTube::~ColonWallTube() = default;

void
ColonWallTube::Weld(const SurfaceMesh & flat)
{
  const std::vector<int> source = FlatSourcePoints(flat, "the flat surface");
  std::map<int, int>     numbers;
  for (int i = 0; i < flat.NumberOfVertices(); ++i)
  {
    const auto [place, isNew] = numbers.try_emplace(source[i], static_cast<int>(m_FlatOfVertex.size()));
    if (isNew)
    {
      m_FlatOfVertex.push_back(i);
      m_IsOnCut.push_back(0);
    }
    else
    {
      m_IsOnCut[place->second] = 1;
    }
    m_VertexOfFlat.push_back(place->second);
  }
  m_V.resize(m_FlatOfVertex.size(), 3);
  for (std::size_t vertex = 0; vertex < m_FlatOfVertex.size(); ++vertex)
  {
    m_V.row(vertex) = flat.V.row(m_FlatOfVertex[vertex]);
  }
  m_F = flat.F.unaryExpr([this](int i) { return m_VertexOfFlat[i]; });
  m_Connectivity = std::make_unique<SurfaceConnectivity>(m_F, this->NumberOfVertices());
}

void
ColonWallTube::CountTurns(const SurfaceMesh & flat, const Eigen::MatrixX2d & uv)
{
  const auto turnsOfCopy = [&](int i) {
    return static_cast<int>(std::lround((uv(i, 1) - m_Uv(m_VertexOfFlat[i], 1)) / m_Circumference));
  };
  m_TurnsOfEdge.assign(m_Connectivity->NumberOfEdges(), 0);
  for (int face = 0; face < m_F.rows(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int edge = m_Connectivity->EdgeOfFace(face, k);
      if (edge >= 0)
      {
        const int  turns = turnsOfCopy(flat.F(face, (k + 1) % 3)) - turnsOfCopy(flat.F(face, k));
        const bool runsForward = m_F(face, k) < m_F(face, (k + 1) % 3);
        m_TurnsOfEdge[edge] = runsForward ? turns : -turns;
      }
    }
  }
}

int
ColonWallTube::Turns(int a, int b) const
{
  const int turns = m_TurnsOfEdge[m_Connectivity->FindEdge(a, b)];
  return a < b ? turns : -turns;
}

double
ColonWallTube::ArcLengthOfU(double u) const
{
  const double place = std::clamp(u / m_ColumnWidth - 0.5, 0.0, static_cast<double>(m_ArcLengthOfColumn.size()) - 1.0);
  const auto   i = static_cast<std::size_t>(place);
  const auto   next = std::min(i + 1, m_ArcLengthOfColumn.size() - 1);
  return m_ArcLengthOfColumn[i] + (place - i) * (m_ArcLengthOfColumn[next] - m_ArcLengthOfColumn[i]);
}

// Searches only near the centerline point of the vertex's column, to exclude touching loops.
void
ColonWallTube::MeasureArcLength(const FlatColon & colon, const CurveSet & centerline)
{
  const CenterlineMatch match = MatchCenterline(colon, centerline);
  m_Warnings = match.warnings;
  m_ArcLengthOfColumn = match.arcLengthOfColumn;
  m_ColumnWidth = match.columnWidth;
  constexpr double reach = 50.0; // mm along the line; chosen: touching loops are farther
  m_ArcLength.resize(m_V.rows());
  for (int vertex = 0; vertex < this->NumberOfVertices(); ++vertex)
  {
    const double guess = this->ArcLengthOfU(m_Uv(vertex, 0));
    const auto & arc = match.arcLength;
    const auto   begin = std::lower_bound(arc.data(), arc.data() + arc.size(), guess - reach) - arc.data();
    double       least = std::numeric_limits<double>::max();
    m_ArcLength[vertex] = guess;
    for (auto i = begin; i < arc.size() && arc[i] <= guess + reach; ++i)
    {
      const double distance = (match.points.row(i) - m_V.row(vertex)).squaredNorm();
      if (distance < least)
      {
        least = distance;
        m_ArcLength[vertex] = arc[i];
      }
    }
  }
}
} // namespace shapeton
