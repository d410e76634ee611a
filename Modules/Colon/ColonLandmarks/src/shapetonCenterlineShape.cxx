#include "shapetonCenterlineShape.h"

#include "shapetonExceptions.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
void
OrderedCenterline(const CurveSet & centerline, VertexMatrix & points, Eigen::VectorXd & arcLength)
{
  if (centerline.curves.size() != 1 || centerline.curves[0].size() < 2)
  {
    throw InputError("the centerline has " + std::to_string(centerline.curves.size()) +
                     " curves; landmarks require one line of several points, from the rectum to the cecum");
  }
  const Eigen::VectorXd    arc = PointValues(centerline, "arcLength", "the centerline");
  const std::vector<int> & order = centerline.curves[0];
  points.resize(order.size(), 3);
  arcLength.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    points.row(i) = centerline.V.row(order[i]);
    arcLength[i] = arc[order[i]];
    if (i > 0 && !(arcLength[i] >= arcLength[i - 1]))
    {
      throw InputError("the array arcLength of the centerline decreases along the line. Give a line from the rectum to "
                       "the cecum, as written by ColonSegmentation.");
    }
  }
  if (!(arcLength[arcLength.size() - 1] > arcLength[0]))
  {
    throw InputError("the centerline has zero length");
  }
}

CenterlineShape::CenterlineShape(const CurveSet & centerline)
{
  VertexMatrix    points;
  Eigen::VectorXd arc;
  OrderedCenterline(centerline, points, arc);
  m_Begin = arc[0];
  const Eigen::Index last = arc.size() - 1;
  const int          size = static_cast<int>(std::floor((arc[last] - arc[0]) / Step)) + 1;
  m_Points.resize(std::max(size, 2), 3);
  Eigen::Index k = 0;
  for (int i = 0; i < this->Size(); ++i)
  {
    const double s = this->ArcLengthAt(i);
    while (k + 1 < last && arc[k + 1] < s)
    {
      ++k;
    }
    const double span = arc[k + 1] - arc[k];
    const double t = span > 0.0 ? std::clamp((s - arc[k]) / span, 0.0, 1.0) : 0.0;
    m_Points.row(i) = (1.0 - t) * points.row(k) + t * points.row(k + 1);
  }
}

CenterlineShape
CenterlineShape::Mirrored() const
{
  CenterlineShape mirrored(*this);
  mirrored.m_Points.col(0) *= -1.0;
  return mirrored;
}

CenterlineShape
CenterlineShape::Reversed() const
{
  CenterlineShape reversed(*this);
  reversed.m_Points = m_Points.colwise().reverse().eval();
  return reversed;
}

VertexMatrix
CenterlineShape::Smoothed(double deviation) const
{
  const double        sigma = deviation / Step;
  const int           reach = static_cast<int>(std::ceil(4.0 * sigma));
  std::vector<double> weights;
  for (int k = -reach; k <= reach; ++k)
  {
    weights.push_back(sigma > 0.0 ? std::exp(-0.5 * k * k / (sigma * sigma)) : 1.0);
  }
  VertexMatrix result(this->Size(), 3);
  for (int i = 0; i < this->Size(); ++i)
  {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double             total = 0.0;
    for (int k = -reach; k <= reach; ++k)
    {
      sum += weights[k + reach] * m_Points.row(std::clamp(i + k, 0, this->Size() - 1));
      total += weights[k + reach];
    }
    result.row(i) = sum / total;
  }
  return result;
}

VertexMatrix
CenterlineShape::Tangents(double deviation) const
{
  const VertexMatrix points = this->Smoothed(deviation);
  VertexMatrix       result(this->Size(), 3);
  for (int i = 0; i < this->Size(); ++i)
  {
    const Eigen::RowVector3d chord = points.row(std::min(i + 1, this->Size() - 1)) - points.row(std::max(i - 1, 0));
    const double             length = chord.norm();
    result.row(i) = length > 0.0 ? Eigen::RowVector3d(chord / length) : Eigen::RowVector3d(0.0, 0.0, 1.0);
  }
  return result;
}

Eigen::VectorXd
CenterlineShape::Turning(double chord, double deviation) const
{
  const VertexMatrix points = this->Smoothed(deviation);
  const int          reach = std::max(1, static_cast<int>(std::lround(chord / Step)));
  Eigen::VectorXd    result(this->Size());
  for (int i = 0; i < this->Size(); ++i)
  {
    const Eigen::RowVector3d before = points.row(i) - points.row(std::max(i - reach, 0));
    const Eigen::RowVector3d behind = points.row(std::min(i + reach, this->Size() - 1)) - points.row(i);
    const double             norms = before.norm() * behind.norm();
    result[i] = norms > 0.0 ? std::acos(std::clamp(before.dot(behind) / norms, -1.0, 1.0)) * 180.0 / Pi : 0.0;
  }
  return result;
}

VertexMatrix
CenterlineShape::PlacesInBox() const
{
  const Eigen::RowVector3d low = m_Points.colwise().minCoeff();
  const Eigen::RowVector3d extent = (m_Points.colwise().maxCoeff() - low).cwiseMax(1e-9);
  VertexMatrix             result(this->Size(), 3);
  for (int i = 0; i < this->Size(); ++i)
  {
    result.row(i) = (m_Points.row(i) - low).cwiseQuotient(extent);
  }
  return result;
}
} // namespace shapeton
