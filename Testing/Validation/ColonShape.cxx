#include "ColonShape.h"
#include "Tables.h"

#include "shapetonFlatColonAxis.h"
#include "shapetonPi.h"
#include "shapetonQuantiles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

using namespace shapeton;

namespace
{
/** Section of the centerline (mm). */
struct Stretch
{
  double begin{ 0.0 };
  double end{ 0.0 };

  double
  Length() const
  {
    return end - begin;
  }
  bool
  Holds(double arcLength) const
  {
    return arcLength >= begin && arcLength < end;
  }
};

/** Section 0 is the whole line, followed by the segments; empty if a border is missing. */
std::array<Stretch, 7>
StretchesOf(const ColonSegments & segments, double length)
{
  std::map<int, double> borders{ { 0, 0.0 }, { 6, length } };
  for (const SegmentBorder & border : segments.borders)
  {
    borders[border.number] = border.arcLength;
  }
  std::array<Stretch, 7> stretches;
  stretches[0] = { 0.0, length };
  for (int segment = 1; segment <= 6; ++segment)
  {
    if (borders.count(segment - 1) && borders.count(segment))
    {
      stretches[segment] = { borders[segment - 1], borders[segment] };
    }
  }
  return stretches;
}

/** \class SectionMeter
 * \brief Radius of the circle with the area of the wall's cross section, for each mm of the line; 0 where the map has
 * no column. */
class SectionMeter
{
public:
  SectionMeter(const FlatColonGrid & grid, const std::vector<double> & distances)
  {
    std::vector<int> columns;
    for (int column = 0; column < grid.Columns(); ++column)
    {
      const double radius = RadiusOf(grid, column);
      const auto   place = static_cast<std::size_t>(std::max(0.0, distances[column]));
      if (std::isfinite(radius))
      {
        m_Radii.resize(std::max(m_Radii.size(), place + 1), 0.0);
        columns.resize(m_Radii.size(), 0);
        m_Radii[place] += radius;
        ++columns[place];
      }
    }
    for (std::size_t place = 0; place < m_Radii.size(); ++place)
    {
      m_Radii[place] /= std::max(1, columns[place]);
    }
  }

  std::vector<double>
  Within(const Stretch & stretch) const
  {
    std::vector<double> radii;
    for (std::size_t place = 0; place < m_Radii.size(); ++place)
    {
      if (stretch.Holds(static_cast<double>(place)) && m_Radii[place] > 0.0)
      {
        radii.push_back(m_Radii[place]);
      }
    }
    return radii;
  }

  /** Mean over 20 mm of the line; 0 without values. */
  double
  MeanAbout(double arcLength) const
  {
    const std::vector<double> radii = this->Within({ arcLength - 10.0, arcLength + 10.0 });
    double                    sum = 0.0;
    for (const double radius : radii)
    {
      sum += radius;
    }
    return sum / std::max<std::size_t>(1, radii.size());
  }

private:
  /** Radius from the vector area of the column, which need not be planar; NaN if the column has a hole. */
  static double
  RadiusOf(const FlatColonGrid & grid, int column)
  {
    const Eigen::Vector3d first = grid.PointOfPixel(column, 0);
    Eigen::Vector3d       area = Eigen::Vector3d::Zero();
    for (int row = 0; row < grid.Rows(); ++row)
    {
      const Eigen::Vector3d here = grid.PointOfPixel(column, row) - first;
      const Eigen::Vector3d next = grid.PointOfPixel(column, (row + 1) % grid.Rows()) - first;
      area += 0.5 * here.cross(next);
    }
    return std::sqrt(area.norm() / Pi);
  }

  std::vector<double> m_Radii;
};

/** \class ThicknessMeter
 * \brief Thickness of folds between their flanks, along the rows of the map. */
class ThicknessMeter
{
public:
  ThicknessMeter(const FlatColon & flat, const HaustralFolds & folds) : m_Grid(flat.Grid()), m_Axis(flat.Axis())
  {
    const itk::Size<2> size = folds.labels->GetLargestPossibleRegion().GetSize();
    for (itk::IndexValueType row = 0; row < static_cast<itk::IndexValueType>(size[1]); ++row)
    {
      for (itk::IndexValueType column = 0; column < static_cast<itk::IndexValueType>(size[0]); ++column)
      {
        const int label = folds.labels->GetPixel({ { column, row } });
        if (label > 0)
        {
          Stretch & stretch = m_Rows[label].try_emplace(static_cast<int>(row), Stretch{ 1e9, -1e9 }).first->second;
          stretch.begin = std::min(stretch.begin, static_cast<double>(column));
          stretch.end = std::max(stretch.end, static_cast<double>(column));
        }
      }
    }
  }

  /** Median thickness at half of the height, over rows where the fold has at least half of its maximum height. NaN if
   * fewer than three rows show both flanks. */
  double
  ThicknessOf(const HaustralFold & fold) const
  {
    const auto          rows = m_Rows.find(fold.label);
    std::vector<double> chords;
    if (fold.height >= 3.0 && rows != m_Rows.end())
    {
      for (const auto & [row, columns] : rows->second)
      {
        const double chord =
          this->ChordIn(row, static_cast<int>(columns.begin), static_cast<int>(columns.end), fold.height);
        if (chord > 0.0)
        {
          chords.push_back(chord);
        }
      }
    }
    return chords.size() < 3 ? std::nan("") : UpperMedian(std::move(chords));
  }

private:
  double
  Radius(int column, int row) const
  {
    return (m_Grid.PointOfPixel(column, row) - m_Axis.centers.row(column).transpose()).norm();
  }

  /** Straight thickness of the fold in a row of the map; 0 if a flank is missing. */
  double
  ChordIn(int row, int first, int last, double height) const
  {
    int crest = first;
    for (int column = first; column <= last; ++column)
    {
      crest = this->Radius(column, row) < this->Radius(crest, row) ? column : crest;
    }
    const double top = this->Radius(crest, row);
    const double depth = std::min({ this->DepthBeside(row, crest, -1), this->DepthBeside(row, crest, 1), height });
    if (!(depth >= 0.5 * height))
    {
      return 0.0;
    }
    const double level = top + 0.5 * depth;
    return (this->FlankAt(row, crest, -1, level) - this->FlankAt(row, crest, 1, level)).norm();
  }

  /** Descent of the wall next to the crest within 25 columns. */
  double
  DepthBeside(int row, int crest, int step) const
  {
    constexpr int reach = 25;
    double        depth = 0.0;
    for (int column = crest; std::abs(column - crest) <= reach && column >= 0 && column < m_Grid.Columns();
         column += step)
    {
      depth = std::max(depth, this->Radius(column, row) - this->Radius(crest, row));
    }
    return depth;
  }

  /** First point after the crest where the wall reaches this distance from the axis; such a point must exist. */
  Eigen::Vector3d
  FlankAt(int row, int crest, int step, double level) const
  {
    int column = crest;
    while (this->Radius(column, row) < level)
    {
      column += step;
    }
    const double below = this->Radius(column - step, row);
    const double share = (level - below) / (this->Radius(column, row) - below);
    return (1.0 - share) * m_Grid.PointOfPixel(column - step, row) + share * m_Grid.PointOfPixel(column, row);
  }

  const FlatColonGrid &                 m_Grid;
  const FlatColonAxis &                 m_Axis;
  std::map<int, std::map<int, Stretch>> m_Rows; ///< columns of each label, per row
};

/** \class FoldMeter
 * \brief Cross sections and folds of a colon, per section. */
class FoldMeter
{
public:
  FoldMeter(const FlatColon & flat, const CurveSet & centerline, const ColonTaeniae & taeniae)
    : m_Grid(flat.Grid())
    , m_Distances(DistanceOfColumns(flat.Axis(), centerline))
    , m_Sections(m_Grid, m_Distances)
    , m_Folds(Find(flat, TaeniaCurves(taeniae)))
    , m_Thickness(flat, m_Folds)
  {}

  void
  Measure(const Stretch & stretch, SegmentShape & shape) const
  {
    shape.radii = m_Sections.Within(stretch);
    double turns = 0.0; // sum over all folds, around the tube
    int    number = 0;
    for (const HaustralFold & fold : m_Folds.folds)
    {
      const double arcLength = m_Distances[m_Grid.PixelOfUv(fold.centerUv).column];
      const double radius = m_Sections.MeanAbout(arcLength);
      if (stretch.Holds(arcLength) && radius > 0.0)
      {
        ++number;
        turns += fold.length / (2.0 * Pi * radius);
        shape.extents.push_back(fold.length / radius * 180.0 / Pi);
        AddIfKnown(fold.height, shape.heights);
        AddIfKnown(m_Thickness.ThicknessOf(fold), shape.thicknesses);
      }
    }
    shape.foldsPerDecimeter.push_back(100.0 * number / stretch.Length());
    AddIfKnown(stretch.Length() / turns, shape.spacings);
  }

private:
  static HaustralFolds
  Find(const FlatColon & flat, const CurveSet & taeniae)
  {
    HaustralFoldSettings options;
    options.taeniae = taeniae.curves.empty() ? nullptr : &taeniae;
    return FindHaustralFolds(flat, options);
  }
  static void
  AddIfKnown(double value, std::vector<double> & values)
  {
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }

  const FlatColonGrid & m_Grid;
  std::vector<double>   m_Distances; ///< distance of each column along the line
  SectionMeter          m_Sections;
  HaustralFolds         m_Folds;
  ThicknessMeter        m_Thickness;
};

/** Points of the line, one per mm, smoothed by a Gaussian of 10 mm. */
VertexMatrix
Smoothed(const VertexMatrix & V)
{
  constexpr int reach = 30;
  VertexMatrix  smoothed(V.rows(), 3);
  for (Eigen::Index i = 0; i < V.rows(); ++i)
  {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double             weights = 0.0;
    for (int k = -reach; k <= reach; ++k)
    {
      const double weight = std::exp(-0.005 * k * k);
      sum += weight * V.row(std::clamp<Eigen::Index>(i + k, 0, V.rows() - 1));
      weights += weight;
    }
    smoothed.row(i) = sum / weights;
  }
  return smoothed;
}

/** Length, tortuosity, turning and inscribed radii. */
void
MeasureLine(const CurveSet & centerline, const Stretch & stretch, SegmentShape & shape)
{
  const Eigen::VectorXd     arcLength = PointValues(centerline, "arcLength", "the centerline");
  const Eigen::VectorXd     radius = PointValues(centerline, "radius", "the centerline");
  const Eigen::VectorXd     gap = PointValues(centerline, "gap", "the centerline");
  const VertexMatrix        smoothed = Smoothed(centerline.V);
  std::vector<Eigen::Index> inside;
  double                    turning = 0.0;
  for (Eigen::Index i = 0; i < arcLength.size(); ++i)
  {
    if (!stretch.Holds(arcLength[i]))
    {
      continue;
    }
    inside.push_back(i);
    if (gap[i] == 0.0)
    {
      shape.inscribedRadii.push_back(radius[i]);
    }
    if (i > 0 && i + 1 < arcLength.size())
    {
      const Eigen::Vector3d before = smoothed.row(i) - smoothed.row(i - 1);
      const Eigen::Vector3d behind = smoothed.row(i + 1) - smoothed.row(i);
      turning += std::atan2(before.cross(behind).norm(), before.dot(behind));
    }
  }
  const double chord = (centerline.V.row(inside.back()) - centerline.V.row(inside.front())).norm();
  shape.lengths.push_back(stretch.Length());
  shape.tortuosities.push_back(stretch.Length() / chord);
  shape.turnings.push_back(turning * 180.0 / Pi * 100.0 / stretch.Length());
}
} // namespace

const std::vector<ShapeMeasure> shapeMeasures = {
  { "Length along the centerline, mm", &SegmentShape::lengths },
  { "Tortuosity: length over distance of the ends", &SegmentShape::tortuosities },
  { "Turning of the centerline smoothed by 10 mm, degrees per dm", &SegmentShape::turnings },
  { "Inscribed radius on the centerline, mm", &SegmentShape::inscribedRadii },
  { "Radius of the circle with the area of the cross-section, mm", &SegmentShape::radii },
  { "Folds per dm", &SegmentShape::foldsPerDecimeter },
  { "Fold spacing along the wall, mm", &SegmentShape::spacings },
  { "Fold height, mm", &SegmentShape::heights },
  { "Fold thickness at half height, mm", &SegmentShape::thicknesses },
  { "Circumferential extent of folds, degrees", &SegmentShape::extents },
};

ColonShape
MeasureColonShape(const FlatColon & flat, const CurveSet & centerline)
{
  const ColonLandmarks landmarks = FindColonLandmarks(flat, centerline);
  const FoldMeter      folds(flat, centerline, landmarks.taeniae);
  const double         length = PointValues(centerline, "arcLength", "the centerline").maxCoeff();
  const auto           stretches = StretchesOf(landmarks.segments, length);
  ColonShape           shapes;
  for (std::size_t segment = 0; segment < shapes.size(); ++segment)
  {
    if (stretches[segment].Length() > 1.0)
    {
      MeasureLine(centerline, stretches[segment], shapes[segment]);
      folds.Measure(stretches[segment], shapes[segment]);
    }
  }
  return shapes;
}

void
AddShape(const ColonShape & other, ColonShape & shape)
{
  for (std::size_t segment = 0; segment < shape.size(); ++segment)
  {
    for (const ShapeMeasure & measure : shapeMeasures)
    {
      Append(other[segment].*measure.samples, shape[segment].*measure.samples);
    }
  }
}
