#include "shapetonTaeniaNames.h"

#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace shapeton
{
namespace
{
constexpr double stepOfRows = 10.0;   // mm along the colon; chosen
constexpr double fromBorders = 15.0;  // mm from flexures, where directions change; chosen
constexpr int    leastRows = 6;       // of a segment; chosen
constexpr double leastMargin = 0.4;   // see the header
constexpr double backwardTilt = 30.0; // degrees, of the libera of the transverse colon; fitted to three real colons

/** Values at distances along a colon, interpolated linearly. */
template <typename TPoints>
Eigen::Vector3d
PointAt(const std::vector<double> & arcLength, const TPoints & points, double s)
{
  const auto   next = std::upper_bound(arcLength.begin() + 1, arcLength.end() - 1, s);
  const auto   i = static_cast<std::size_t>(next - arcLength.begin());
  const double length = arcLength[i] - arcLength[i - 1];
  const double share = length > 0.0 ? std::clamp((s - arcLength[i - 1]) / length, 0.0, 1.0) : 0.0;
  return (1.0 - share) * points[i - 1] + share * points[i];
}

/** The centerline, in ascending order. */
struct Line
{
  explicit Line(const CurveSet & centerline)
  {
    const Eigen::VectorXd arc = PointValues(centerline, "arcLength", "the centerline");
    for (const int vertex : centerline.curves.front())
    {
      points.emplace_back(centerline.V.row(vertex));
      arcLength.push_back(arc[vertex]);
    }
  }

  std::vector<Eigen::Vector3d> points;
  std::vector<double>          arcLength;
};

/** The direction of the libera in a segment, LPS. */
Eigen::Vector3d
ExpectedLibera(int segment)
{
  constexpr int transverse = 4;
  const double  tilt = backwardTilt * Pi / 180.0;
  return segment == transverse ? Eigen::Vector3d(0.0, std::sin(tilt), -std::cos(tilt))
                               : Eigen::Vector3d(0.0, -1.0, 0.0);
}

/** Agreement in one row, for each taenia that may be the libera. */
std::array<double, 3>
AgreementAt(const ColonTaeniae & taeniae, const Line & line, int segment, double s)
{
  const Eigen::Vector3d center = PointAt(line.arcLength, line.points, s);
  const Eigen::Vector3d along =
    (PointAt(line.arcLength, line.points, s + stepOfRows) - PointAt(line.arcLength, line.points, s - stepOfRows))
      .normalized();
  const auto across = [&](const Eigen::Vector3d & way) { return (way - way.dot(along) * along).normalized(); };
  const Eigen::Vector3d                libera = across(ExpectedLibera(segment));
  const Eigen::Vector3d                around = along.cross(libera);
  const double                         third = std::sqrt(0.75); // sine of a third of a turn
  const std::array<Eigen::Vector3d, 3> expected{
    { libera, -0.5 * libera + third * around, -0.5 * libera - third * around }
  };
  std::array<double, 3> agreement{};
  for (int first = 0; first < 3; ++first)
  {
    for (int i = 0; i < 3; ++i)
    {
      const ColonTaenia & taenia = taeniae.taeniae[(first - i + 3) % 3];
      agreement[first] += across(PointAt(taenia.arcLength, taenia.points, s) - center).dot(expected[i]) / 3.0;
    }
  }
  return agreement;
}

/** Beginning and end of a segment, mm; empty if a border is missing. */
std::optional<std::array<double, 2>>
ExtentOf(const ColonSegments & segments, int segment)
{
  std::optional<double> begin;
  std::optional<double> end;
  for (const SegmentBorder & border : segments.borders)
  {
    begin = border.number == segment - 1 ? border.arcLength : begin;
    end = border.number == segment ? border.arcLength : end;
  }
  if (!begin || !end)
  {
    return std::nullopt;
  }
  return std::array<double, 2>{ { *begin + fromBorders, *end - fromBorders } };
}

std::optional<TaeniaNameEvidence>
EvidenceOf(const ColonTaeniae & taeniae, const Line & line, const ColonSegments & segments, int segment)
{
  const auto extent = ExtentOf(segments, segment);
  const int  rows = extent ? static_cast<int>(((*extent)[1] - (*extent)[0]) / stepOfRows) : 0;
  if (rows < leastRows)
  {
    return std::nullopt;
  }
  TaeniaNameEvidence evidence{ segment, {} };
  for (int row = 0; row < rows; ++row)
  {
    const auto agreement = AgreementAt(taeniae, line, segment, (*extent)[0] + row * stepOfRows);
    for (int first = 0; first < 3; ++first)
    {
      evidence.agreement[first] += agreement[first] / rows;
    }
  }
  return evidence;
}

/** The taenia of best agreement, and by how much it exceeds the second best. */
std::pair<int, double>
BestOf(const TaeniaNameEvidence & evidence)
{
  auto       sorted = evidence.agreement;
  const auto best = std::max_element(evidence.agreement.begin(), evidence.agreement.end());
  std::sort(sorted.begin(), sorted.end());
  return { static_cast<int>(best - evidence.agreement.begin()), sorted[2] - sorted[1] };
}

/** Why the names are unknown; empty if they are known. */
std::string
ReasonAgainst(const std::vector<TaeniaNameEvidence> & evidence)
{
  if (evidence.size() < 2)
  {
    return "fewer than two of descending, transverse and ascending colon are known";
  }
  for (const TaeniaNameEvidence & one : evidence)
  {
    if (BestOf(one).second < leastMargin)
    {
      return "the " + NameOfSegment(one.segment) + " is turned halfway between two taeniae";
    }
    if (BestOf(one).first != BestOf(evidence.front()).first)
    {
      return "the " + NameOfSegment(evidence.front().segment) + " and the " + NameOfSegment(one.segment) +
             " contradict each other";
    }
  }
  return "";
}
} // namespace

std::string
NameOf(TaeniaName name)
{
  static const std::array<std::string, 4> names{ { "", "libera", "mesocolica", "omentalis" } };
  return names[static_cast<std::size_t>(name)];
}

TaeniaNames
NameTaeniae(const ColonTaeniae & taeniae, const CurveSet & centerline, const ColonSegments & segments)
{
  TaeniaNames result;
  if (taeniae.taeniae.size() != 3)
  {
    result.reason = "no taeniae were found";
    return result;
  }
  const Line line(centerline);
  for (const int segment : { 3, 4, 5 })
  {
    if (const auto evidence = EvidenceOf(taeniae, line, segments, segment))
    {
      result.evidence.push_back(*evidence);
    }
  }
  result.reason = ReasonAgainst(result.evidence);
  if (result.reason.empty())
  {
    const int libera = BestOf(result.evidence.front()).first;
    result.names[libera] = TaeniaName::Libera;
    result.names[(libera + 2) % 3] = TaeniaName::Omentalis;
    result.names[(libera + 1) % 3] = TaeniaName::Mesocolica;
  }
  return result;
}
} // namespace shapeton
