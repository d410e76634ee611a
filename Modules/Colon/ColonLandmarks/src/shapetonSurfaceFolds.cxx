#include "shapetonSurfaceFolds.h"

#include "shapetonSmoothedCurvature.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace shapeton
{
namespace
{
double
AreaOfFace(const ColonWallTube & tube, int face)
{
  const Eigen::Vector3d a = tube.Points().row(tube.Faces()(face, 0));
  const Eigen::Vector3d b = tube.Points().row(tube.Faces()(face, 1));
  const Eigen::Vector3d c = tube.Points().row(tube.Faces()(face, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

/** Of each face, the mean of its corners. */
std::vector<double>
CurvatureOfFaces(const ColonWallTube & tube, const Eigen::VectorXd & curvature)
{
  std::vector<double> result;
  for (int face = 0; face < tube.Faces().rows(); ++face)
  {
    const auto corners = tube.Faces().row(face);
    result.push_back((curvature[corners[0]] + curvature[corners[1]] + curvature[corners[2]]) / 3.0);
  }
  return result;
}

/** Otsu's threshold of the area by curvature, from -0.1 to 0.2 per mm. */
double
ThresholdBetween(const ColonWallTube & tube, const std::vector<double> & curvature, const std::vector<char> & isBridged)
{
  constexpr int            bins = 300;
  constexpr double         low = -0.1;
  constexpr double         width = 0.001;
  std::array<double, bins> area{};
  double                   all = 0.0;
  double                   moment = 0.0;
  for (std::size_t face = 0; face < curvature.size(); ++face)
  {
    if (isBridged.empty() || isBridged[face] == 0)
    {
      const int    bin = static_cast<int>(std::clamp((curvature[face] - low) / width, 0.0, bins - 1.0));
      const double own = AreaOfFace(tube, static_cast<int>(face));
      area[bin] += own;
      all += own;
      moment += own * bin;
    }
  }
  double below = 0.0;
  double momentBelow = 0.0;
  double most = 0.0;
  int    best = bins - 1;
  for (int bin = 0; bin < bins; ++bin)
  {
    below += area[bin];
    momentBelow += area[bin] * bin;
    const double above = all - below;
    const double apart = below > 0.0 && above > 0.0 ? momentBelow / below - (moment - momentBelow) / above : 0.0;
    if (below * above * apart * apart > most)
    {
      most = below * above * apart * apart;
      best = bin;
    }
  }
  // A wall without folds would be parted within: folds bulge into the lumen.
  return std::max(low + width * (best + 1), 0.0);
}

/** Faces of candidates that hang together with this one; they are taken off the candidates. */
std::vector<int>
TakeComponent(const ColonWallTube & tube, int seed, std::vector<char> & isCandidate)
{
  std::vector<int> faces{ seed };
  isCandidate[seed] = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int edge = tube.Connectivity().EdgeOfFace(faces[i], k);
      if (edge < 0)
      {
        continue;
      }
      for (const int next : tube.Connectivity().FacesOfEdge(edge))
      {
        if (isCandidate[next])
        {
          isCandidate[next] = 0;
          faces.push_back(next);
        }
      }
    }
  }
  return faces;
}

double
ExtentOfFaces(const ColonWallTube & tube, const std::vector<int> & faces)
{
  Eigen::AlignedBox3d box;
  for (const int face : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      box.extend(Eigen::Vector3d(tube.Points().row(tube.Faces()(face, k)).transpose()));
    }
  }
  return box.diagonal().norm();
}
} // namespace

SurfaceFolds
FindSurfaceFolds(const ColonWallTube & tube, const std::vector<char> & isBridged, const SurfaceFoldOptions & options)
{
  SurfaceFolds result;
  result.curvature = SmoothedMeanCurvature(tube.Points(), tube.Faces(), options.smoothingTime, CurvatureUnit::PerArea);
  const std::vector<double> curvature = CurvatureOfFaces(tube, result.curvature);
  result.leastCurvature =
    options.leastCurvature > 0.0 ? options.leastCurvature : ThresholdBetween(tube, curvature, isBridged);
  const int         numberOfFaces = static_cast<int>(tube.Faces().rows());
  std::vector<char> isCandidate(numberOfFaces, 0);
  for (int face = 0; face < numberOfFaces; ++face)
  {
    isCandidate[face] = curvature[face] >= result.leastCurvature && (isBridged.empty() || isBridged[face] == 0);
  }
  result.foldOfFace.assign(numberOfFaces, 0);
  for (int seed = 0; seed < numberOfFaces; ++seed)
  {
    if (!isCandidate[seed])
    {
      continue;
    }
    const std::vector<int> faces = TakeComponent(tube, seed, isCandidate);
    double                 area = 0.0;
    for (const int face : faces)
    {
      area += AreaOfFace(tube, face);
    }
    if (area >= options.leastArea && ExtentOfFaces(tube, faces) >= options.leastExtent)
    {
      ++result.number;
      result.area += area;
      for (const int face : faces)
      {
        result.foldOfFace[face] = result.number;
      }
    }
  }
  return result;
}
} // namespace shapeton
