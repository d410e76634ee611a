#include "LandmarkErrors.h"

#include "Tables.h"
#include "shapetonPi.h"
#include "shapetonSurfaceLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double close = 10.0; // mm

using Points = std::vector<Eigen::Vector3d>;

/** Arc length of the nearest point of a line. */
double
ArcLengthNear(const shapeton::CurveSet & line, const Eigen::VectorXd & arcLength, const Eigen::Vector3d & point)
{
  Eigen::Index nearest = 0;
  (line.V.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return arcLength[nearest];
}

void
MeasureFlexures(const shapeton::ColonLandmarks & landmarks,
                const shapeton::CurveSet &       centerline,
                const shapeton::ColonAnatomy &   anatomy,
                LandmarkErrors &                 errors)
{
  const shapeton::CurveSet truth = anatomy.Centerline();
  const Eigen::VectorXd    segment = PointValues(truth, "segment", "the truth");
  const Eigen::VectorXd    arcLength = PointValues(centerline, "arcLength", "the centerline");
  errors.flexures.fill(infinite);
  for (Eigen::Index i = 1; i < segment.size(); ++i)
  {
    const int flexure = static_cast<int>(segment[i]) - 1;
    if (segment[i] == segment[i - 1] || flexure < 1 || flexure > 4)
    {
      continue;
    }
    const Eigen::Vector3d border = 0.5 * (truth.V.row(i - 1) + truth.V.row(i)).transpose();
    for (const shapeton::SegmentBorder & found : landmarks.segments.borders)
    {
      if (found.number == flexure)
      {
        errors.flexures[flexure - 1] = std::abs(found.arcLength - ArcLengthNear(centerline, arcLength, border));
        errors.flexureConfidence[flexure - 1] = found.confidence;
      }
    }
  }
  errors.areFlexuresWithin30 =
    std::all_of(errors.flexures.begin(), errors.flexures.end(), [](double error) { return error <= 30.0; });
}

double
ShareWithTrueSegment(const shapeton::ColonLandmarks & landmarks, const shapeton::ColonAnatomy & anatomy)
{
  double right = 0.0;
  double all = 0.0;
  for (int face = 0; face < landmarks.tube->Faces().rows(); ++face)
  {
    const auto            corners = landmarks.tube->Faces().row(face);
    const Eigen::Vector3d a = landmarks.tube->Points().row(corners[0]);
    const Eigen::Vector3d b = landmarks.tube->Points().row(corners[1]);
    const Eigen::Vector3d c = landmarks.tube->Points().row(corners[2]);
    const int             segment = anatomy.Evaluate((a + b + c) / 3.0).segment;
    const double          area = segment == 0 ? 0.0 : (b - a).cross(c - a).norm(); // 0: a bridge far from the wall
    all += area;
    right += segment == landmarks.segments.segmentOfFace[face] ? area : 0.0;
  }
  return all > 0.0 ? right / all : 0.0;
}

/** Points of the three true taeniae along one section of the colon, and the circumference (mm) of the wall without
 * folds at each. */
struct Stretch
{
  std::array<Points, 3>              taeniae;
  std::array<std::vector<double>, 3> circumferences;
};

/** Sorted distances between the k-th points of the three taeniae (mm). Where a fold covers the phantom's
 * centerline, the taeniae meet in the fold. */
std::array<double, 3>
DistancesBetween(const shapeton::CurveSet & taeniae, std::size_t k)
{
  const auto at = [&](int t) { return taeniae.V.row(taeniae.curves[t][std::min(k, taeniae.curves[t].size() - 1)]); };
  std::array<double, 3> distances{ (at(0) - at(1)).norm(), (at(0) - at(2)).norm(), (at(1) - at(2)).norm() };
  std::sort(distances.begin(), distances.end());
  return distances;
}

bool
AreOnePoint(const shapeton::CurveSet & taeniae, std::size_t k)
{
  return DistancesBetween(taeniae, k)[2] < 1.0;
}

/** Open sections between the collapsed ones, where a wall exists: bridges are longer than the collapsed sections. */
std::vector<Stretch>
OpenStretches(const shapeton::ColonAnatomy & anatomy, const shapeton::ColonWallTube & tube)
{
  const shapeton::SurfaceLocator locator(tube.Points(), tube.Faces());
  const shapeton::CurveSet       line = anatomy.Centerline();
  const Eigen::VectorXd          lineArc = PointValues(line, "arcLength", "the truth");
  const Eigen::VectorXd          collapsed = PointValues(line, "collapsed", "the truth");
  const Eigen::VectorXd          radius = PointValues(line, "radius", "the truth");
  std::vector<int>               stretchOf(lineArc.size(), -1);
  int                            stretches = 0;
  for (Eigen::Index i = 0; i < lineArc.size(); ++i)
  {
    const bool begins = collapsed[i] == 0.0 && (i == 0 || collapsed[i - 1] != 0.0);
    stretches += begins ? 1 : 0;
    stretchOf[i] = collapsed[i] == 0.0 ? stretches - 1 : -1;
  }
  const shapeton::CurveSet taeniae = anatomy.Taeniae();
  const Eigen::VectorXd    arc = PointValues(taeniae, "arcLength", "the truth");
  std::vector<Stretch>     result(stretches);
  for (std::size_t t = 0; t < 3; ++t)
  {
    for (std::size_t k = 0; k < taeniae.curves[t].size(); ++k)
    {
      const int      vertex = taeniae.curves[t][k];
      const double * begin = lineArc.data();
      const auto     i = std::lower_bound(begin, begin + lineArc.size() - 1, arc[vertex]) - begin;
      if (stretchOf[i] >= 0 && !AreOnePoint(taeniae, k) && locator.FindClosest(taeniae.V.row(vertex)).distance < close)
      {
        result[stretchOf[i]].taeniae[t].push_back(taeniae.V.row(vertex).transpose());
        result[stretchOf[i]].circumferences[t].push_back(shapeton::TwoPi * radius[i]);
      }
    }
  }
  return result;
}

/** The taeniae of all sections. */
std::array<Points, 3>
Joined(const std::vector<Stretch> & stretches)
{
  std::array<Points, 3> all;
  for (const Stretch & stretch : stretches)
  {
    for (int t = 0; t < 3; ++t)
    {
      all[t].insert(all[t].end(), stretch.taeniae[t].begin(), stretch.taeniae[t].end());
    }
  }
  return all;
}

/** Distances of the points of each true taenia from its found taenia, for the assignment that has the smallest mean
 * distance. */
std::array<std::vector<double>, 3>
DistancesOfTaeniae(const shapeton::ColonTaeniae & found, const std::array<Points, 3> & truth)
{
  std::array<std::array<std::vector<double>, 3>, 3> distances;
  for (int t = 0; t < 3; ++t)
  {
    for (int f = 0; f < 3; ++f)
    {
      for (const Eigen::Vector3d & point : truth[t])
      {
        distances[t][f].push_back(DistanceToLine(point, found.taeniae[f].points));
      }
    }
  }
  std::array<int, 3>                 order{ 0, 1, 2 };
  std::array<std::vector<double>, 3> best;
  double                             least = infinite;
  do
  {
    double sum = 0.0;
    for (int t = 0; t < 3; ++t)
    {
      sum = std::accumulate(distances[t][order[t]].begin(), distances[t][order[t]].end(), sum);
    }
    if (sum < least)
    {
      least = sum;
      best = { distances[0][order[0]], distances[1][order[1]], distances[2][order[2]] };
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

std::vector<double>
AsOne(const std::array<std::vector<double>, 3> & parts)
{
  std::vector<double> all;
  for (const std::vector<double> & part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

double
ShareWithin10(const std::vector<double> & distances)
{
  const auto near = std::count_if(distances.begin(), distances.end(), [](double d) { return d <= close; });
  return static_cast<double>(near) / static_cast<double>(distances.size());
}

void
MeasureTaeniae(const shapeton::ColonLandmarks & landmarks,
               const shapeton::ColonAnatomy &   anatomy,
               LandmarkErrors &                 errors)
{
  errors.taeniaMean = errors.taenia95 = errors.taeniaGreatest = errors.taeniaWorstMean = infinite;
  errors.taeniaOfTurn = infinite;
  const shapeton::ColonTaeniae & found = landmarks.taeniae;
  const std::vector<Stretch>     stretches = OpenStretches(anatomy, *landmarks.tube);
  if (found.taeniae.size() != 3 || Joined(stretches)[0].empty())
  {
    return;
  }
  std::array<std::vector<double>, 3> ofTaeniae;
  std::vector<double>                squaresOfTurns;
  for (const Stretch & stretch : stretches)
  {
    const std::array<std::vector<double>, 3> own = DistancesOfTaeniae(found, stretch.taeniae);
    for (int t = 0; t < 3; ++t)
    {
      ofTaeniae[t].insert(ofTaeniae[t].end(), own[t].begin(), own[t].end());
      for (std::size_t k = 0; k < own[t].size(); ++k)
      {
        const double turns = own[t][k] / stretch.circumferences[t][k];
        squaresOfTurns.push_back(turns * turns);
      }
    }
  }
  errors.taeniaOfTurn = std::sqrt(MeanOf(squaresOfTurns));
  std::vector<double> distances = AsOne(ofTaeniae);
  std::sort(distances.begin(), distances.end());
  errors.taeniaMean = MeanOf(distances);
  errors.taeniaWorstMean = std::max({ MeanOf(ofTaeniae[0]), MeanOf(ofTaeniae[1]), MeanOf(ofTaeniae[2]) });
  errors.taenia95 = shapeton::LowerQuantile(distances, 0.95);
  errors.taeniaGreatest = distances.back();
  errors.taeniaWithin10 = ShareWithin10(distances);
  errors.taeniaIdentified10 = ShareWithin10(AsOne(DistancesOfTaeniae(found, Joined(stretches))));
}
} // namespace

LandmarkErrors
MeasureLandmarks(const shapeton::ColonLandmarks & landmarks,
                 const shapeton::CurveSet &       centerline,
                 const shapeton::ColonAnatomy &   anatomy)
{
  LandmarkErrors errors;
  MeasureFlexures(landmarks, centerline, anatomy, errors);
  errors.labeledShare = ShareWithTrueSegment(landmarks, anatomy);
  MeasureTaeniae(landmarks, anatomy, errors);
  return errors;
}

std::vector<Eigen::Vector3d>
MarkersOfTruth(const shapeton::ColonAnatomy & anatomy, const shapeton::SurfaceMesh & surface)
{
  constexpr int                  transverse = 4;
  constexpr double               seen = 2.0; // mm
  const shapeton::SurfaceLocator locator(surface.V, surface.F);
  const shapeton::CurveSet       taeniae = anatomy.Taeniae();
  const Eigen::VectorXd          arc = PointValues(taeniae, "arcLength", "the truth");
  std::vector<Eigen::Vector3d>   markers;
  for (const std::vector<int> & curve : taeniae.curves)
  {
    std::vector<int> own;
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      if (anatomy.SegmentAt(arc[curve[k]]) == transverse && DistancesBetween(taeniae, k)[0] > close)
      {
        own.push_back(curve[k]);
      }
    }
    const double middle = arc[own[own.size() / 2]];
    std::sort(
      own.begin(), own.end(), [&](int a, int b) { return std::abs(arc[a] - middle) < std::abs(arc[b] - middle); });
    const auto place = std::find_if(own.begin(), own.end(), [&](int vertex) {
      return locator.FindClosest(taeniae.V.row(vertex).transpose()).distance < seen;
    });
    markers.push_back(taeniae.V.row(place == own.end() ? own.front() : *place).transpose());
  }
  return markers;
}

double
DistanceToLine(const Eigen::Vector3d & point, const std::vector<Eigen::Vector3d> & line)
{
  double least = infinite;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const Eigen::Vector3d step = line[i + 1] - line[i];
    const double          square = step.squaredNorm();
    const double          t = square > 0.0 ? std::clamp((point - line[i]).dot(step) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, (point - line[i] - t * step).norm());
  }
  return least;
}
