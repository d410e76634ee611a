#ifndef shapetonSchematicColon_h
#define shapetonSchematicColon_h

#include "shapetonCurveSet.h"

#include <array>
#include <vector>

/** A schematic centerline of a colon with known flexures. */
struct SchematicColon
{
  shapeton::CurveSet    centerline;
  std::array<double, 4> flexures{}; ///< arcLength, mm
};

/** A polyline with corners rounded by averaging; points every millimeter. LPS, mm. */
inline shapeton::CurveSet
RoundedCurve(const std::vector<Eigen::Vector3d> & places)
{
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    const Eigen::Vector3d step = places[i + 1] - places[i];
    for (double t = 0.0; t < step.norm(); t += 1.0)
    {
      points.push_back(places[i] + step * (t / step.norm()));
    }
  }
  shapeton::CurveSet curve;
  curve.V.resize(points.size(), 3);
  curve.curves.emplace_back();
  shapeton::SurfaceArray arc{ "arcLength", shapeton::SurfaceArray::ValueMatrix::Zero(points.size(), 1), false };
  const int              last = static_cast<int>(points.size()) - 1;
  for (int i = 0; i <= last; ++i)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = -12; k <= 12; ++k)
    {
      sum += points[std::min(std::max(i + k, 0), last)];
    }
    curve.V.row(i) = sum.transpose() / 25.0;
    arc.values(i, 0) = i == 0 ? 0.0 : arc.values(i - 1, 0) + (curve.V.row(i) - curve.V.row(i - 1)).norm();
    curve.curves[0].push_back(i);
  }
  curve.pointArrays.push_back(arc);
  return curve;
}

inline double
ArcLengthNear(const shapeton::CurveSet & curve, const Eigen::Vector3d & point)
{
  Eigen::Index i = 0;
  (curve.V.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&i);
  return curve.pointArrays[0].values(i, 0);
}

/** \param loop points of a loop in the descending colon, to make it redundant. */
inline SchematicColon
MakeSchematicColon(const std::vector<Eigen::Vector3d> & loop = {})
{
  // Anal verge; rectum along the sacrum; a sigmoid loop; descending; transverse hanging down; ascending; cecum.
  std::vector<Eigen::Vector3d> places{ { 0, 40, 0 },      { 0, 62, 60 },     { 0, 45, 120 },    { -45, -10, 135 },
                                       { 10, -50, 150 },  { 70, -20, 130 },  { 105, 30, 160 },  { 125, 45, 240 },
                                       { 130, 50, 350 },  { 80, -20, 320 },  { 40, -50, 230 },  { 0, -55, 215 },
                                       { -50, -45, 240 }, { -90, -15, 290 }, { -115, 40, 320 }, { -125, 45, 240 },
                                       { -118, 40, 150 } };
  const std::array<Eigen::Vector3d, 4> flexures{ places[2], places[6], places[8], places[14] };
  places.insert(places.begin() + 8, loop.begin(), loop.end());
  SchematicColon colon;
  colon.centerline = RoundedCurve(places);
  for (int k = 0; k < 4; ++k)
  {
    colon.flexures[k] = ArcLengthNear(colon.centerline, flexures[k]);
  }
  return colon;
}

/** The reversed line. */
inline shapeton::CurveSet
ReversedCurve(shapeton::CurveSet curve)
{
  const double length = curve.pointArrays[0].values.maxCoeff();
  curve.V = shapeton::VertexMatrix(curve.V.colwise().reverse());
  curve.pointArrays[0].values =
    shapeton::SurfaceArray::ValueMatrix((length - curve.pointArrays[0].values.array()).matrix().colwise().reverse());
  return curve;
}

#endif
