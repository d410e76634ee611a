// The ground truth of ColonAnatomy.
#include "shapetonColonAnatomyData.h"

#include "shapetonParallelFor.h"
#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
constexpr double c_GridStep = 5.0;      // mm between wall points
constexpr int    c_InscribedReach = 15; // steps of the curve on each side that may limit an inscribed ball
constexpr double c_CapCenter = 0.375;   // height of the center of volume of half an ellipsoid

/** Builds a CurveSet point by point. */
class CurveWriter
{
public:
  CurveWriter(std::vector<std::string> pointNames, std::vector<std::string> cellNames)
    : m_PointNames(std::move(pointNames)), m_CellNames(std::move(cellNames))
  {}

  void
  BeginCurve(const std::vector<double> & values)
  {
    m_Set.curves.emplace_back();
    m_CellValues.push_back(values);
  }
  void
  AddPoint(const Vector3d & point, const std::vector<double> & values)
  {
    m_Set.curves.back().push_back(static_cast<int>(m_Points.size()));
    m_Points.push_back(point);
    m_PointValues.push_back(values);
  }

  CurveSet
  Finish()
  {
    m_Set.V.resize(m_Points.size(), 3);
    for (std::size_t i = 0; i < m_Points.size(); ++i)
    {
      m_Set.V.row(i) = m_Points[i];
    }
    m_Set.pointArrays = ArraysOf(m_PointNames, m_PointValues);
    m_Set.cellArrays = ArraysOf(m_CellNames, m_CellValues);
    return m_Set;
  }

private:
  static std::vector<SurfaceArray>
  ArraysOf(const std::vector<std::string> & names, const std::vector<std::vector<double>> & rows)
  {
    static const std::vector<std::string> whole{ "segment", "collapsed", "materialId", "onFold",
                                                 "taenia",  "fold",      "flattened" };
    std::vector<SurfaceArray>             arrays;
    for (std::size_t column = 0; column < names.size(); ++column)
    {
      SurfaceArray array{ names[column], SurfaceArray::ValueMatrix(rows.size(), 1), false };
      array.areIntegers = std::find(whole.begin(), whole.end(), array.name) != whole.end();
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        array.values(i, 0) = rows[i][column];
      }
      arrays.push_back(array);
    }
    return arrays;
  }

  std::vector<std::string>         m_PointNames;
  std::vector<std::string>         m_CellNames;
  CurveSet                         m_Set;
  std::vector<Vector3d>            m_Points;
  std::vector<std::vector<double>> m_PointValues;
  std::vector<std::vector<double>> m_CellValues;
};

/** Numbering of the wall points of a patient. */
class MaterialGrid
{
public:
  explicit MaterialGrid(const ColonPlan & plan)
  {
    for (double m = c_GridStep; m < plan.Length() - 0.5 * c_GridStep; m += c_GridStep)
    {
      m_First.push_back(m_Total);
      m_Columns.push_back(std::max(6, static_cast<int>(std::lround(TwoPi * plan.RadiusAt(m) / c_GridStep))));
      m_Total += m_Columns.back();
    }
  }
  int
  Rows() const
  {
    return static_cast<int>(m_First.size());
  }
  int
  Columns(int row) const
  {
    return m_Columns[row];
  }
  static double
  MaterialOf(int row)
  {
    return c_GridStep * (row + 1);
  }
  double
  AngleOf(int row, int column) const
  {
    return WrapAngle(TwoPi * column / m_Columns[row]);
  }
  int
  IdOf(int row, int column) const
  {
    return m_First[row] + column;
  }
  int
  Nearest(double material, double angle) const
  {
    const int row = std::clamp(static_cast<int>(std::lround(material / c_GridStep)) - 1, 0, this->Rows() - 1);
    const int n = m_Columns[row];
    return this->IdOf(row, (static_cast<int>(std::lround(angle / TwoPi * n)) % n + n) % n);
  }

private:
  int              m_Total{ 0 };
  std::vector<int> m_First;
  std::vector<int> m_Columns;
};

// Wall and fold crest points at each step, for inscribed radii.
std::vector<std::vector<Vector3d>>
InnerPoints(const ColonField & field)
{
  const ColonCurve &                 curve = field.GetCurve();
  const int                          steps = curve.GetNumberOfSteps();
  std::vector<std::vector<Vector3d>> points(steps + 1);
  for (int k = 0; k <= steps; ++k)
  {
    for (int a = 0; a < 64; ++a)
    {
      const double angle = WrapAngle(TwoPi * a / 64);
      const double radius = std::max(0.0, field.GetRelief().RadiusAt(k, angle).value);
      points[k].push_back(curve.At(k).position + radius * field.GetCurve().Direction(k, angle));
    }
  }
  for (const FoldCourse & fold : field.GetRelief().GetFolds())
  {
    for (double u = -1.0; u < 1.01; u += 0.05)
    {
      ReliefValue t, crest;
      fold.At(u, t, crest);
      const double angle = WrapAngle(fold.angle + u * fold.halfAngle);
      points[std::clamp(static_cast<int>(std::lround(t.value)), 0, steps)].push_back(
        curve.At(t.value).position + std::max(0.0, crest.value) * field.GetCurve().Direction(t.value, angle));
    }
  }
  return points;
}

double
InscribedRadius(const std::vector<std::vector<Vector3d>> & points, const Vector3d & center, int step)
{
  double least = 1e9;
  for (int k = std::max(0, step - c_InscribedReach);
       k <= std::min(static_cast<int>(points.size()) - 1, step + c_InscribedReach);
       ++k)
  {
    for (const Vector3d & point : points[k])
    {
      least = std::min(least, (point - center).squaredNorm());
    }
  }
  return std::sqrt(least);
}
} // namespace

CurveSet
ColonAnatomy::Centerline() const
{
  const ColonPlan &  plan = m_Data->plan;
  const ColonField & field = m_Data->field;
  const ColonCurve & curve = field.GetCurve();
  const auto         inner = InnerPoints(field);
  CurveWriter        writer({ "arcLength", "radius", "inscribedRadius", "segment", "collapsed" }, {});
  writer.BeginCurve({});
  for (int k = 0; k <= curve.GetNumberOfSteps(); ++k)
  {
    const Vector3d center = curve.At(k).position;
    const double   radius = std::max(0.0, field.GetRelief().MeanRadiusAt(k));
    writer.AddPoint(center,
                    { curve.ArcLengthAt(k),
                      radius,
                      InscribedRadius(inner, center, k),
                      1.0 * plan.SegmentAt(k * curve.GetStep()),
                      radius < 0.5 ? 1.0 : 0.0 });
  }
  return writer.Finish();
}

CurveSet
ColonAnatomy::Taeniae() const
{
  const ColonPlan &  plan = m_Data->plan;
  const ColonField & field = m_Data->field;
  const ColonCurve & curve = field.GetCurve();
  const MaterialGrid grid(plan);
  CurveWriter        writer({ "arcLength", "materialId" }, { "taenia", "name" });
  for (int taenia = 0; taenia < 3; ++taenia)
  {
    constexpr std::array<double, 3> names{ { 1.0, 3.0, 2.0 } };
    writer.BeginCurve({ 1.0 * taenia, m_Data->parameters.anatomicalTaeniae ? names[taenia] : 0.0 });
    for (int row = 0; row < grid.Rows(); ++row)
    {
      const double material = MaterialGrid::MaterialOf(row);
      if (plan.SegmentAt(material) < 2)
      {
        continue;
      }
      const double t = material / curve.GetStep();
      const double angle = WrapAngle(plan.TaeniaAngle(taenia, material));
      double       radius;
      writer.AddPoint(field.WallPoint(t, angle, radius), { curve.ArcLengthAt(t), 1.0 * grid.Nearest(material, angle) });
    }
  }
  return writer.Finish();
}

CurveSet
ColonAnatomy::Folds() const
{
  const ColonPlan &  plan = m_Data->plan;
  const ColonField & field = m_Data->field;
  const ColonCurve & curve = field.GetCurve();
  CurveWriter        writer({ "crestHeight" },
                     { "fold", "height", "thickness", "angularExtent", "arcLength", "segment", "flattened" });
  const auto &       folds = field.GetRelief().GetFolds();
  for (std::size_t i = 0; i < folds.size(); ++i)
  {
    const FoldCourse & fold = folds[i];
    ReliefValue        t, crest;
    fold.At(0.0, t, crest);
    writer.BeginCurve({ i + 1.0,
                        fold.height,
                        2 * fold.halfThickness,
                        2 * fold.halfAngle * 180.0 / Pi,
                        curve.ArcLengthAt(t.value),
                        1.0 * plan.SegmentAt(t.value * curve.GetStep()),
                        fold.isFlattened ? 1.0 : 0.0 });
    for (int k = -16; k <= 16; ++k)
    {
      const double u = k / 16.0;
      const double angle = WrapAngle(fold.angle + u * fold.halfAngle);
      fold.At(u, t, crest);
      const double radius = field.GetRelief().RadiusAt(t.value, angle).value;
      writer.AddPoint(curve.At(t.value).position +
                        std::max(0.0, crest.value) * field.GetCurve().Direction(t.value, angle),
                      { radius - crest.value });
    }
  }
  return writer.Finish();
}

std::vector<ColonPolyp>
ColonAnatomy::Polyps() const
{
  const ColonPlan &       plan = m_Data->plan;
  const ColonField &      field = m_Data->field;
  const ColonCurve &      curve = field.GetCurve();
  const MaterialGrid      grid(plan);
  std::vector<ColonPolyp> polyps;
  for (std::size_t i = 0; i < plan.polyps.size(); ++i)
  {
    const PolypPlan & from = plan.polyps[i];
    const PolypBody & body = field.GetPolyps()[i];
    ColonPolyp        polyp;
    polyp.id = static_cast<int>(i) + 1;
    polyp.kind = from.kind;
    polyp.diameter = from.diameter;
    polyp.height = from.height + from.stalk;
    // The center of the protruding part of a cap.
    polyp.position = body.isPedunculated ? body.head : Vector3d(body.head + c_CapCenter * body.height * body.axis);
    polyp.base = body.base;
    polyp.arcLength = curve.ArcLengthAt(body.t);
    polyp.segment = plan.SegmentAt(body.t * curve.GetStep());
    polyp.onFold = from.fold >= 0;
    polyp.materialId = grid.Nearest(from.material, from.angle);
    polyps.push_back(polyp);
  }
  return polyps;
}

std::vector<ColonDiverticulum>
ColonAnatomy::Diverticula() const
{
  const ColonPlan &              plan = m_Data->plan;
  const ColonField &             field = m_Data->field;
  const ColonCurve &             curve = field.GetCurve();
  const MaterialGrid             grid(plan);
  std::vector<ColonDiverticulum> diverticula;
  for (const DiverticulumBody & body : field.GetDiverticula())
  {
    const DiverticulumPlan & from = plan.diverticula[body.plan];
    ColonDiverticulum        diverticulum;
    diverticulum.id = body.plan + 1;
    diverticulum.mouth = body.mouth;
    diverticulum.position = body.sac;
    diverticulum.neck = 2.0 * body.neckRadius;
    diverticulum.diameter = 2.0 * body.radius;
    diverticulum.arcLength = curve.ArcLengthAt(body.t);
    diverticulum.segment = plan.SegmentAt(from.material);
    diverticulum.materialId = grid.Nearest(from.material, from.angle);
    diverticulum.content = from.stool > 0.0 ? "stool" : "lumen";
    diverticulum.intensity = from.stool;
    diverticula.push_back(diverticulum);
  }
  return diverticula;
}

ColonValve
ColonAnatomy::Valve() const
{
  const ColonPlan &  plan = m_Data->plan;
  const ColonField & field = m_Data->field;
  const ColonCurve & curve = field.GetCurve();
  ColonValve         valve;
  valve.arcLength = curve.ArcLengthAt(plan.valve.material / curve.GetStep());
  if (const auto & lips = field.GetLips())
  {
    valve.kind = "lips";
    valve.base = lips->base;
    valve.direction = lips->axis;
    valve.slit = lips->slit;
    valve.upperLip = lips->Crest(1);
    valve.lowerLip = lips->Crest(-1);
    valve.length = lips->length;
    valve.height = lips->height;
    valve.thickness = lips->thickness;
    valve.mouth = lips->base + lips->MouthHeight() * lips->axis;
  }
  else
  {
    const PolypBody & bump = field.GetPolyps().back();
    valve.kind = "bump";
    valve.base = bump.base;
    valve.direction = bump.axis;
    valve.slit = curve.At(bump.t).first.normalized().cross(bump.axis);
    valve.length = valve.thickness = 2.0 * bump.radius;
    valve.height = bump.height;
    valve.mouth = valve.upperLip = valve.lowerLip = bump.base + bump.height * bump.axis;
  }
  valve.position = valve.base + 0.5 * valve.height * valve.direction;
  return valve;
}

// Both ends are hemispheres, so rays from the last point of the centerline reach every point.
Vector3d
ColonAnatomy::CecalPole() const
{
  const ColonPlan &  plan = m_Data->plan;
  const ColonField & field = m_Data->field;
  const ColonCurve & curve = field.GetCurve();
  const double       end = curve.GetNumberOfSteps();
  const Vector3d     mouth = curve.At(plan.valve.material / curve.GetStep()).position;
  const Vector3d     middle = curve.At(end).position;
  const Vector3d     ahead = curve.At(end).first.normalized();
  Vector3d           pole = middle;
  for (int ring = 0; ring <= 16; ++ring)
  {
    const double tilt = 0.5 * Pi * ring / 16;
    for (int k = 0; k < 32; ++k)
    {
      const Vector3d side = curve.Direction(end, WrapAngle(TwoPi * k / 32));
      double         distance;
      const Vector3d point = field.WallAlong(middle, std::cos(tilt) * ahead + std::sin(tilt) * side, distance);
      pole = (point - mouth).squaredNorm() > (pole - mouth).squaredNorm() ? point : pole;
    }
  }
  return pole;
}

CurveSet
ColonAnatomy::Correspondence() const
{
  const ColonPlan &                  plan = m_Data->plan;
  const ColonField &                 field = m_Data->field;
  const ColonCurve &                 curve = field.GetCurve();
  const MaterialGrid                 grid(plan);
  std::vector<std::vector<Vector3d>> points(grid.Rows());
  std::vector<std::vector<double>>   radii(grid.Rows());
  ParallelFor(static_cast<std::size_t>(grid.Rows()), [&](std::size_t row) {
    for (int k = 0; k < grid.Columns(row); ++k)
    {
      double radius;
      points[row].push_back(
        field.WallPoint(MaterialGrid::MaterialOf(row) / curve.GetStep(), grid.AngleOf(row, k), radius));
      radii[row].push_back(radius);
    }
  });
  CurveWriter writer({ "materialId", "arcLength", "angle", "segment", "collapsed", "onFold" }, {});
  for (int row = 0; row < grid.Rows(); ++row)
  {
    const double t = MaterialGrid::MaterialOf(row) / curve.GetStep();
    for (int k = 0; k < grid.Columns(row); ++k)
    {
      const double angle = grid.AngleOf(row, k);
      const double rise = field.GetRelief().RadiusAt(t, angle).value - radii[row][k];
      writer.BeginCurve({});
      writer.AddPoint(points[row][k],
                      { 1.0 * grid.IdOf(row, k),
                        curve.ArcLengthAt(t),
                        angle,
                        1.0 * plan.SegmentAt(t * curve.GetStep()),
                        radii[row][k] <= 0 ? 1.0 : 0.0,
                        rise > 1.0 && radii[row][k] > 0 ? 1.0 : 0.0 });
    }
  }
  return writer.Finish();
}
} // namespace shapeton
