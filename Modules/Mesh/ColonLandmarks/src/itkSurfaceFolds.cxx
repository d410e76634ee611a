#include "itkSurfaceFolds.h"

#include "itkSmoothedCurvature.h"

#include <Eigen/Geometry>

namespace itk
{
namespace
{
double
AreaOfFace(const ColonTube & tube, int face)
{
  const Eigen::Vector3d a = tube.Points().row(tube.Faces()(face, 0));
  const Eigen::Vector3d b = tube.Points().row(tube.Faces()(face, 1));
  const Eigen::Vector3d c = tube.Points().row(tube.Faces()(face, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

/** Faces of candidates that hang together with this one; they are taken off the candidates. */
std::vector<int>
TakeComponent(const ColonTube & tube, int seed, std::vector<char> & isCandidate)
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
ExtentOfFaces(const ColonTube & tube, const std::vector<int> & faces)
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
FindSurfaceFolds(const ColonTube & tube, const std::vector<char> & isBridged, const SurfaceFoldOptions & options)
{
  SurfaceFolds result;
  result.curvature = SmoothedMeanCurvature(tube.Points(), tube.Faces(), options.smoothingTime, CurvatureUnit::PerArea);
  const int         numberOfFaces = static_cast<int>(tube.Faces().rows());
  std::vector<char> isCandidate(numberOfFaces, 0);
  for (int face = 0; face < numberOfFaces; ++face)
  {
    const auto   corners = tube.Faces().row(face);
    const double mean =
      (result.curvature[corners[0]] + result.curvature[corners[1]] + result.curvature[corners[2]]) / 3.0;
    isCandidate[face] = mean >= options.leastCurvature && (isBridged.empty() || isBridged[face] == 0);
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
} // namespace itk
