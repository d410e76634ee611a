#include "shapetonFlatColonGrid.h"

#include "shapetonFlatRaster.h"
#include "shapetonFlatSurface.h"
#include "shapetonFlatVertexValues.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int    leastRows = 4;              // around; chosen: fewer do not show a circumference
constexpr double mostPixels = 1 << 27;       // chosen: 0.5 GB of pixels at 4 bytes
constexpr double mostPixelsAcross = 1 << 16; // per axis; chosen

/** The source vertices, renumbered from 0 in order. */
std::vector<int>
NumberSources(const std::vector<int> & sourcePoints)
{
  std::vector<int> known = sourcePoints;
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::vector<int> numbers;
  numbers.reserve(sourcePoints.size());
  for (const int point : sourcePoints)
  {
    numbers.push_back(static_cast<int>(std::lower_bound(known.begin(), known.end(), point) - known.begin()));
  }
  return numbers;
}

double
SignedArea(const Eigen::Vector2d & a, const Eigen::Vector2d & b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** Twice the signed area of the map. */
double
SignedAreaOfMap(const Eigen::MatrixX2d & uv, const FaceMatrix & F)
{
  double sum = 0.0;
  for (int face = 0; face < F.rows(); ++face)
  {
    sum += SignedArea(uv.row(F(face, 1)) - uv.row(F(face, 0)), uv.row(F(face, 2)) - uv.row(F(face, 0)));
  }
  return sum;
}

/** 1 if the faces are oriented toward the tube axis, -1 otherwise. */
double
SignOfInside(const VertexMatrix & V, const FaceMatrix & F, const Eigen::VectorXd & u, double partLength)
{
  const int        parts = 1 + static_cast<int>(u.maxCoeff() / partLength);
  VertexMatrix     middle = VertexMatrix::Zero(parts, 3);
  Eigen::VectorXd  area = Eigen::VectorXd::Zero(parts);
  VertexMatrix     centers(F.rows(), 3);
  VertexMatrix     normals(F.rows(), 3);
  std::vector<int> partOfFace(F.rows());
  for (int face = 0; face < F.rows(); ++face)
  {
    const Eigen::Vector3d a = V.row(F(face, 0)), b = V.row(F(face, 1)), c = V.row(F(face, 2));
    const double          meanU = (u[F(face, 0)] + u[F(face, 1)] + u[F(face, 2)]) / 3.0;
    centers.row(face) = (a + b + c) / 3.0;
    normals.row(face) = (b - a).cross(c - a);
    partOfFace[face] = std::clamp(static_cast<int>(meanU / partLength), 0, parts - 1);
    middle.row(partOfFace[face]) += normals.row(face).norm() * centers.row(face);
    area[partOfFace[face]] += normals.row(face).norm();
  }
  double sum = 0.0;
  for (int face = 0; face < F.rows(); ++face)
  {
    const int part = partOfFace[face];
    sum += area[part] > 0.0 ? normals.row(face).dot(middle.row(part) / area[part] - centers.row(face)) : 0.0;
  }
  return sum < 0.0 ? -1.0 : 1.0;
}
} // namespace

FlatColonGrid::FlatColonGrid(const SurfaceMesh & flat, const FlatColonGridOptions & options, const std::string & what)
{
  this->ReadArrays(flat, what);
  this->ChooseSize(options);
  FlatVertexValues values =
    MakeFlatVertexValues(m_V, m_F, m_Uv, m_SourceOfVertex, options.curvatureLength, options.normalLength);
  const double inside = SignOfInside(m_V, m_F, m_Uv.col(0), 0.25 * m_Circumference);
  m_InwardNormals = inside * values.normals;
  m_Curvature = inside * values.curvature;
  m_Scale = std::move(values.scale);
  double sign = SignedAreaOfMap(m_Uv, m_F) < 0.0 ? -1.0 : 1.0;
  m_IsMirrored = inside * sign > 0.0;
  if (m_IsMirrored)
  {
    m_Uv.col(1) = m_Circumference - m_Uv.col(1).array(); // now in row direction
    sign = -sign;
  }
  const SnappedMap map = SnapMap(m_Uv, m_SourceOfVertex, m_PixelSize, m_Rows);
  m_FaceOfPixel = RasterizeFaces(map, m_F, m_Columns, m_Rows, sign < 0.0 ? -1 : 1);
  m_UncoveredPixels = static_cast<int>(std::count(m_FaceOfPixel.begin(), m_FaceOfPixel.end(), -1));
  if (2.0 * m_UncoveredPixels > m_FaceOfPixel.size())
  {
    throw InputError(what + ": its faces cover less than half of the map; uv, circumference and length disagree");
  }
}

FlatColonGrid::~FlatColonGrid() = default;

void
FlatColonGrid::ReadArrays(const SurfaceMesh & flat, const std::string & what)
{
  RequireSound(flat, what);
  m_Uv = FlatCoordinates(flat, what);
  m_SourceOfVertex = NumberSources(FlatSourcePoints(flat, what));
  m_Circumference = FlatCircumference(flat, what);
  m_Length = FlatLength(flat, what);
  const double tolerance = 1e-3 * (m_Length + m_Circumference);
  if (m_Uv.col(0).minCoeff() < -tolerance || m_Uv.col(0).maxCoeff() > m_Length + tolerance)
  {
    throw InputError(what + ": u is out of the range from 0 to length");
  }
  if (m_Uv.col(1).array().abs().maxCoeff() > 100.0 * m_Circumference)
  {
    throw InputError(what + ": v is more than 100 turns out of the range from 0 to circumference");
  }
  m_V = flat.V;
  m_F = flat.F;
  if (const SurfaceArray * bridged = FindSurfaceArray(flat.cellArrays, "bridged"))
  {
    for (Eigen::Index face = 0; face < m_F.rows(); ++face)
    {
      m_IsBridged.push_back(bridged->values(face, 0) > 0.5);
    }
  }
  if (const SurfaceArray * arcLength = FindSurfaceArray(flat.pointArrays, "arcLength"))
  {
    m_ArcLength = arcLength->values.col(0);
  }
}

void
FlatColonGrid::ChooseSize(const FlatColonGridOptions & options)
{
  const double size = options.pixelSize;
  RequireParameter(size > 0.0 && std::isfinite(size), "the pixel size must be greater than 0 mm");
  for (const double length : { options.curvatureLength, options.normalLength })
  {
    RequireParameter(length >= 0.0 && std::isfinite(length),
                     "the smoothing length of curvature and normals must not be negative");
  }
  const double rows = std::round(m_Circumference / size);
  const double columns = std::round(m_Length / size);
  RequireParameter(rows >= leastRows, "the pixel size must be smaller than a fourth of the circumference");
  RequireParameter(rows <= mostPixelsAcross && columns <= mostPixelsAcross && rows * columns <= mostPixels,
                   "the pixel size is too small: the grid is limited to 65536 pixels per axis and 2^27 in total");
  m_Rows = static_cast<int>(rows);
  m_PixelSize = m_Circumference / m_Rows;
  m_Columns = std::max(1, static_cast<int>(std::round(m_Length / m_PixelSize)));
}

Eigen::Vector2d
FlatColonGrid::UvOfPixel(int column, int row) const
{
  const double down = (Wrap(row) + 0.5) * m_PixelSize;
  return { (column + 0.5) * m_PixelSize, m_IsMirrored ? m_Circumference - down : down };
}

FlatPixel
FlatColonGrid::PixelOfUv(const Eigen::Vector2d & uv) const
{
  const double down = m_IsMirrored ? m_Circumference - uv.y() : uv.y();
  const double turn = down / m_Circumference - std::floor(down / m_Circumference);
  const double column = std::clamp(std::floor(uv.x() / m_PixelSize), 0.0, m_Columns - 1.0);
  return { static_cast<int>(column), Wrap(static_cast<int>(turn * m_Rows)) };
}

/** \param uv in image coordinates. */
Eigen::Vector3d
FlatColonGrid::BarycentricOf(int face, Eigen::Vector2d uv) const
{
  const Eigen::Vector2d a = m_Uv.row(m_F(face, 0));
  const Eigen::Vector2d b = m_Uv.row(m_F(face, 1)).transpose() - a;
  const Eigen::Vector2d c = m_Uv.row(m_F(face, 2)).transpose() - a;
  const double          area = SignedArea(b, c);
  if (area == 0.0)
  {
    return Eigen::Vector3d::Constant(1.0 / 3.0);
  }
  const double    middle = a.y() + (b.y() + c.y()) / 3.0;
  const double    turns = std::round((middle - uv.y()) / m_Circumference);
  Eigen::Vector3d best = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  for (const double other : { 0.0, -1.0, 1.0 }) // a face may cover more than half of the circumference
  {
    const Eigen::Vector2d p(uv.x() - a.x(), uv.y() + (turns + other) * m_Circumference - a.y());
    const double          ofB = SignedArea(p, c) / area;
    const double          ofC = SignedArea(b, p) / area;
    const Eigen::Vector3d candidate(1.0 - ofB - ofC, ofB, ofC);
    best = candidate.minCoeff() > best.minCoeff() ? candidate : best;
    if (best.minCoeff() >= 0.0)
    {
      return best;
    }
  }
  best = best.cwiseMax(0.0); // avoids rounding errors of pixels on an edge
  return best / best.sum();
}

Eigen::Vector3d
FlatColonGrid::PointOfPixel(int column, int row) const
{
  const int face = this->FaceOfPixel(column, row);
  if (face < 0)
  {
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const Eigen::Vector3d share =
    this->BarycentricOf(face, { (column + 0.5) * m_PixelSize, (Wrap(row) + 0.5) * m_PixelSize });
  return share[0] * m_V.row(m_F(face, 0)) + share[1] * m_V.row(m_F(face, 1)) + share[2] * m_V.row(m_F(face, 2));
}

FlatSample
FlatColonGrid::SampleOfPixel(int column, int row) const
{
  FlatSample sample;
  sample.face = this->FaceOfPixel(column, row);
  if (sample.face < 0)
  {
    return sample;
  }
  sample.barycentric =
    this->BarycentricOf(sample.face, { (column + 0.5) * m_PixelSize, (Wrap(row) + 0.5) * m_PixelSize });
  sample.scale = 0.0;
  sample.arcLength = this->HasArcLength() ? 0.0 : sample.arcLength;
  for (int k = 0; k < 3; ++k)
  {
    const int    vertex = m_F(sample.face, k);
    const int    source = m_SourceOfVertex[vertex];
    const double share = sample.barycentric[k];
    sample.point += share * m_V.row(vertex);
    sample.inwardNormal += share * m_InwardNormals.row(source);
    sample.curvature += share * m_Curvature[source];
    sample.scale += share * m_Scale[source];
    sample.arcLength += this->HasArcLength() ? share * m_ArcLength[vertex] : 0.0;
  }
  sample.inwardNormal.normalize();
  sample.isBridged = !m_IsBridged.empty() && m_IsBridged[sample.face] != 0;
  return sample;
}

Eigen::Vector2d
FlatColonGrid::UvOfFacePoint(int face, const Eigen::Vector3d & barycentric) const
{
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    uv += barycentric[k] * m_Uv.row(m_F(face, k));
  }
  uv.y() = m_IsMirrored ? m_Circumference - uv.y() : uv.y();
  uv.y() -= m_Circumference * std::floor(uv.y() / m_Circumference);
  uv.y() = uv.y() >= m_Circumference ? 0.0 : uv.y();
  return uv;
}
} // namespace shapeton
