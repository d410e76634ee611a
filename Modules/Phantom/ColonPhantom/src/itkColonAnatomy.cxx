#include "itkColonAnatomy.h"

#include <algorithm>
#include <cmath>

namespace itk
{
using Eigen::Vector3d;

// A smooth tube through a few points, until the full anatomy takes its place.
struct ColonAnatomy::Data
{
  ColonPhantomParameters parameters;
  std::vector<Vector3d>  points;
  std::vector<double>    arcLength;
  std::vector<double>    radius;
  std::vector<int>       segment;
};

ColonAnatomy::ColonAnatomy(const ColonPhantomParameters & parameters)
{
  RequireValid(parameters);
  auto data = std::make_unique<Data>();
  data->parameters = parameters;
  struct Node
  {
    double x, y, z, r;
    int    segment;
  };
  const Node nodes[] = {
    { 0, 52, -152, 4, 1 },    { 0, 42, -124, 5, 1 },    { 0, 62, -105, 22, 1 },   { 2, 72, -80, 24, 1 },
    { 6, 55, -48, 18, 1 },    { -30, 10, -60, 14, 2 },  { -40, -30, -75, 14, 2 }, { 0, -60, -50, 14, 2 },
    { 35, -40, -30, 14, 2 },  { 55, 0, -75, 14, 2 },    { 90, 30, -60, 15, 2 },   { 112, 50, -10, 16, 3 },
    { 118, 60, 50, 17, 3 },   { 116, 60, 100, 18, 3 },  { 105, 40, 130, 19, 4 },  { 75, -10, 105, 20, 4 },
    { 45, -60, 50, 20, 4 },   { 0, -70, 10, 20, 4 },    { -45, -60, 45, 21, 4 },  { -85, -15, 85, 21, 4 },
    { -110, 30, 85, 22, 5 },  { -114, 50, 40, 23, 5 },  { -112, 50, -10, 24, 5 }, { -105, 40, -50, 28, 6 },
    { -98, 22, -80, 28, 6 },
  };
  const int count = static_cast<int>(std::size(nodes));
  for (int i = 0; i + 1 < count; ++i)
  {
    const auto at = [&](int k) {
      const Node & n = nodes[std::clamp(k, 0, count - 1)];
      return Eigen::Vector4d(n.x, n.y, n.z, n.r);
    };
    for (int j = 0; j < 16; ++j)
    {
      const double          t = j / 16.0;
      const Eigen::Vector4d a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
      const Eigen::Vector4d p =
        0.5 * (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) + t * t * t * (3 * b - a - 3 * c + d));
      data->points.push_back(p.head<3>());
      data->radius.push_back(std::max(3.0, p[3]));
      data->segment.push_back(nodes[i].segment);
      const std::size_t n = data->points.size();
      data->arcLength.push_back(
        n == 1 ? 0.0 : data->arcLength.back() + (data->points[n - 1] - data->points[n - 2]).norm());
    }
  }
  m_Data = std::move(data);
}

ColonAnatomy::~ColonAnatomy() = default;

const ColonPhantomParameters &
ColonAnatomy::GetParameters() const
{
  return m_Data->parameters;
}

ColonAnatomy::Sample
ColonAnatomy::Evaluate(const Vector3d & point) const
{
  Sample sample{ -Reach, 0.0, 0.0, 0 };
  for (std::size_t i = 0; i + 1 < m_Data->points.size(); ++i)
  {
    const Vector3d & a = m_Data->points[i];
    const Vector3d   edge = m_Data->points[i + 1] - a;
    const double     t = std::clamp((point - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double     radius = (1 - t) * m_Data->radius[i] + t * m_Data->radius[i + 1];
    const double     distance = std::min(radius - (point - a - t * edge).norm(), Reach);
    if (distance > sample.distance)
    {
      sample = { distance, m_Data->arcLength[i] + t * edge.norm(), 0.0, m_Data->segment[i] };
    }
  }
  return sample;
}

CurveSet
ColonAnatomy::Centreline() const
{
  const auto  n = static_cast<Eigen::Index>(m_Data->points.size());
  CurveSet    result;
  SurfaceArray arcLength{ "arcLength", SurfaceArray::ValueMatrix(n, 1), false };
  SurfaceArray radius{ "radius", SurfaceArray::ValueMatrix(n, 1), false };
  SurfaceArray segment{ "segment", SurfaceArray::ValueMatrix(n, 1), true };
  SurfaceArray collapsed{ "collapsed", SurfaceArray::ValueMatrix::Zero(n, 1), true };
  result.V.resize(n, 3);
  result.curves.resize(1);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    result.V.row(i) = m_Data->points[i];
    result.curves[0].push_back(static_cast<int>(i));
    arcLength.values(i, 0) = m_Data->arcLength[i];
    radius.values(i, 0) = m_Data->radius[i];
    segment.values(i, 0) = m_Data->segment[i];
  }
  SurfaceArray inscribed = radius;
  inscribed.name = "inscribedRadius";
  result.pointArrays = { arcLength, radius, inscribed, segment, collapsed };
  return result;
}

CurveSet
ColonAnatomy::Taeniae() const
{
  return {};
}

CurveSet
ColonAnatomy::Folds() const
{
  return {};
}

std::vector<ColonPolyp>
ColonAnatomy::Polyps() const
{
  return {};
}

CurveSet
ColonAnatomy::Correspondence() const
{
  return {};
}

SurfaceMesh
ColonAnatomy::Wall(double) const
{
  return {};
}

double
ColonAnatomy::Length() const
{
  return m_Data->arcLength.back();
}

int
ColonAnatomy::SegmentAt(double arcLength) const
{
  const auto   above = std::upper_bound(m_Data->arcLength.begin(), m_Data->arcLength.end(), arcLength);
  const size_t i = above - m_Data->arcLength.begin();
  return m_Data->segment[i == 0 ? 0 : i - 1];
}

std::string
ColonAnatomy::SegmentName(int segment)
{
  static const std::vector<std::string> names{ "rectum", "sigmoid", "descending", "transverse", "ascending", "caecum" };
  return segment >= 1 && segment <= 6 ? names[segment - 1] : std::string();
}

void
ColonAnatomy::BoundingBox(double margin, Vector3d & low, Vector3d & high) const
{
  low.setConstant(1e9);
  high.setConstant(-1e9);
  for (std::size_t i = 0; i < m_Data->points.size(); ++i)
  {
    const Vector3d spread = Vector3d::Constant(m_Data->radius[i] + margin);
    low = low.cwiseMin(m_Data->points[i] - spread);
    high = high.cwiseMax(m_Data->points[i] + spread);
  }
}

Vector3d
ColonAnatomy::SpineAxis(double z)
{
  // The sacrum bends back behind the rectum and forwards again at its tip.
  const double below = std::clamp((-50.0 - z) / 90.0, 0.0, 1.0);
  return { 0.0, 80.0 + 35.0 * std::sin(3.0 * below), z };
}

void
ColonAnatomy::AnalVerge(Vector3d & point, Vector3d & inwards) const
{
  point = m_Data->points[0];
  inwards = (m_Data->points[8] - m_Data->points[0]).normalized();
}
} // namespace itk
