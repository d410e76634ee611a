#include "shapetonSurfaceFolds.h"

#include "shapetonSurfaceConnectivity.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace shapeton
{
namespace
{
double
AreaOfFace(const SurfaceMesh & surface, int face)
{
  const Eigen::Vector3d a = surface.V.row(surface.F(face, 0));
  const Eigen::Vector3d b = surface.V.row(surface.F(face, 1));
  const Eigen::Vector3d c = surface.V.row(surface.F(face, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

std::vector<char>
BridgedFaces(const SurfaceMesh & surface)
{
  std::vector<char>    isBridged(surface.NumberOfFaces(), 0);
  const SurfaceArray * array = FindSurfaceArray(surface.cellArrays, "bridged");
  for (int face = 0; array != nullptr && face < surface.NumberOfFaces(); ++face)
  {
    isBridged[face] = array->values(face, 0) != 0.0;
  }
  return isBridged;
}

/** Values at the points of the flat surface; equal on both sides of the cut. */
Eigen::VectorXd
CurvatureOfPoints(const FlatColon & flat, double time)
{
  const Eigen::VectorXd &  ofTube = flat.Curvature(time);
  const std::vector<int> & source = flat.Grid().SourceOfPoints();
  Eigen::VectorXd          curvature(static_cast<Eigen::Index>(source.size()));
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    curvature[static_cast<Eigen::Index>(i)] = ofTube[source[i]];
  }
  return curvature;
}

/** Connectivity including adjacency across the cut. */
SurfaceConnectivity
ConnectivityOfTube(const FlatColonGrid & grid)
{
  const std::vector<int> & source = grid.SourceOfPoints();
  const FaceMatrix         F = grid.Faces().unaryExpr([&source](int i) { return source[i]; });
  return SurfaceConnectivity(F, static_cast<int>(grid.InwardNormals().rows()));
}

/** Face values: means of the corners. */
std::vector<double>
CurvatureOfFaces(const SurfaceMesh & surface, const Eigen::VectorXd & curvature)
{
  std::vector<double> result;
  for (int face = 0; face < surface.NumberOfFaces(); ++face)
  {
    const auto corners = surface.F.row(face);
    result.push_back((curvature[corners[0]] + curvature[corners[1]] + curvature[corners[2]]) / 3.0);
  }
  return result;
}

/** Otsu's threshold of the area histogram of curvature, from -0.1 to 0.2 per mm. */
double
ThresholdBetween(const SurfaceMesh &         surface,
                 const std::vector<double> & curvature,
                 const std::vector<char> &   isBridged)
{
  constexpr int            bins = 300;
  constexpr double         low = -0.1;    // 1/mm
  constexpr double         width = 0.001; // 1/mm; chosen: far finer than the widths of the classes
  std::array<double, bins> area{};
  double                   all = 0.0;
  double                   moment = 0.0;
  for (std::size_t face = 0; face < curvature.size(); ++face)
  {
    if (isBridged[face] == 0)
    {
      const int    bin = static_cast<int>(std::clamp((curvature[face] - low) / width, 0.0, bins - 1.0));
      const double own = AreaOfFace(surface, static_cast<int>(face));
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
  // The threshold is at least 0, since folds bulge into the lumen; a lower one would find folds in a wall that has
  // none.
  return std::max(low + width * (best + 1), 0.0);
}

/** Collects candidate faces connected to this one and removes them from the candidates. */
std::vector<int>
TakeComponent(const SurfaceConnectivity & tube, int seed, std::vector<char> & isCandidate)
{
  std::vector<int> faces{ seed };
  isCandidate[seed] = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int edge = tube.EdgeOfFace(faces[i], k);
      if (edge < 0)
      {
        continue;
      }
      for (const int next : tube.FacesOfEdge(edge))
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
ExtentOfFaces(const SurfaceMesh & surface, const std::vector<int> & faces)
{
  Eigen::AlignedBox3d box;
  for (const int face : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      box.extend(Eigen::Vector3d(surface.V.row(surface.F(face, k)).transpose()));
    }
  }
  return box.diagonal().norm();
}
} // namespace

SurfaceFolds
FindSurfaceFolds(const FlatColon & flat, const SurfaceFoldOptions & options, const Progress & progress)
{
  const SurfaceMesh &     surface = flat.Surface();
  const std::vector<char> isBridged = BridgedFaces(surface);
  SurfaceFolds            result;
  result.curvature = CurvatureOfPoints(flat, options.smoothingTime);
  progress(0.6);
  const std::vector<double> curvature = CurvatureOfFaces(surface, result.curvature);
  result.leastCurvature =
    options.leastCurvature > 0.0 ? options.leastCurvature : ThresholdBetween(surface, curvature, isBridged);
  const int         numberOfFaces = surface.NumberOfFaces();
  std::vector<char> isCandidate(numberOfFaces, 0);
  for (int face = 0; face < numberOfFaces; ++face)
  {
    isCandidate[face] = curvature[face] >= result.leastCurvature && isBridged[face] == 0;
  }
  const SurfaceConnectivity tube = ConnectivityOfTube(flat.Grid());
  progress(0.9);
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
      area += AreaOfFace(surface, face);
    }
    if (area >= options.leastArea && ExtentOfFaces(surface, faces) >= options.leastExtent)
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
