#include "shapetonSurfaceHandles.h"

#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonTubeCut.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double leastAngularDefect = 1e-6; // radians

/** For each source vertex, one of its vertices on the flat surface. */
FaceMatrix
SourceFaces(const SurfaceMesh & flat, const std::vector<int> & source)
{
  FaceMatrix F(flat.F.rows(), 3);
  for (Eigen::Index corner = 0; corner < F.size(); ++corner)
  {
    F.data()[corner] = source[flat.F.data()[corner]];
  }
  return F;
}

/** Marked vertices connected by edges; each list ascending, lists in the order of their first vertices. */
std::vector<std::vector<int>>
Clusters(const EdgeGraph & graph, const std::vector<char> & isMarked)
{
  std::vector<std::vector<int>> clusters;
  std::vector<char>             isDone(isMarked.size(), 0);
  for (int first = 0; first < graph.NumberOfVertices(); ++first)
  {
    if (!isMarked[first] || isDone[first])
    {
      continue;
    }
    std::vector<int> cluster{ first };
    isDone[first] = 1;
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
      const int vertex = cluster[i];
      for (const EdgeGraph::Step * step = graph.begin(vertex); step != graph.end(vertex); ++step)
      {
        if (isMarked[step->vertex] && !isDone[step->vertex])
        {
          isDone[step->vertex] = 1;
          cluster.push_back(step->vertex);
        }
      }
    }
    std::sort(cluster.begin(), cluster.end());
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

/** Mean of the corners of the faces around the vertices, shifted to the period of the first face: a handle at the seam
 * is placed on the side of that face. */
Eigen::Vector2d
MeanFlatPlace(const SurfaceConnectivity & connectivity,
              const CornerPlaces &        places,
              const std::vector<int> &    vertices,
              double                      period)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  const double    reference = places(3 * connectivity.FacesOfVertex(vertices.front())[0], 1);
  int             number = 0;
  for (const int vertex : vertices)
  {
    for (const int face : connectivity.FacesOfVertex(vertex))
    {
      for (int k = 0; k < 3; ++k)
      {
        Eigen::Vector2d place = places.row(3 * face + k).transpose();
        place.y() -= period > 0.0 ? period * std::round((place.y() - reference) / period) : 0.0;
        sum += place;
        ++number;
      }
    }
  }
  return sum / number;
}

/** 0 for a nonperiodic map. */
double
PeriodOf(const SurfaceMesh & flat)
{
  return FindSurfaceArray(flat.fieldArrays, "circumference") ? FlatCircumference(flat, "the flat surface") : 0.0;
}
} // namespace

/** \equation{6.3} with flat faces, for the genus of each vertex cluster. */
HandleDetection
DetectHandles(const SurfaceConnectivity & connectivity, const SurfaceMesh & flat)
{
  const std::vector<int> source = FlatSourcePoints(flat, "the flat surface");
  const int              greatest = *std::max_element(source.begin(), source.end());
  if (flat.NumberOfFaces() != connectivity.NumberOfFaces() || greatest >= connectivity.NumberOfVertices())
  {
    throw InputError("the flat surface is not a map of this surface");
  }
  const CornerPlaces    places = PlacesOfCorners(flat.F, FlatCoordinates(flat, "the flat surface"));
  const Eigen::VectorXd defects = FlatAngleDefects(SourceFaces(flat, source), connectivity, places);
  const EdgeGraph       graph(connectivity);
  std::vector<char>     isMarked(connectivity.NumberOfVertices(), 0);
  for (Eigen::Index v = 0; v < defects.size(); ++v)
  {
    isMarked[v] = std::abs(defects[v]) > leastAngularDefect;
  }
  Dilate(graph, isMarked, 1);
  HandleDetection detection;
  for (std::vector<int> & cluster : Clusters(graph, isMarked))
  {
    SurfaceHandle handle;
    double        sum = 0.0;
    for (const int v : cluster)
    {
      sum += defects[v];
      handle.place += flat.V.row(v).transpose() / static_cast<double>(cluster.size());
    }
    handle.genus = static_cast<int>(std::lround(-sum / (4.0 * Pi)));
    if (handle.genus <= 0) // negative: next to a boundary, where defects are unknown
    {
      ++detection.falseAlarms;
      continue;
    }
    for (const int v : cluster)
    {
      handle.radius = std::max(handle.radius, (flat.V.row(v).transpose() - handle.place).norm());
    }
    handle.flatPlace = MeanFlatPlace(connectivity, places, cluster, PeriodOf(flat));
    handle.vertices = std::move(cluster);
    detection.genus += handle.genus;
    detection.handles.push_back(std::move(handle));
  }
  return detection;
}

std::vector<char>
FacesNearHandles(const SurfaceConnectivity & connectivity, const std::vector<SurfaceHandle> & handles, int rings)
{
  std::vector<char> isNear(connectivity.NumberOfVertices(), 0);
  for (const SurfaceHandle & handle : handles)
  {
    for (const int v : handle.vertices)
    {
      isNear[v] = 1;
    }
  }
  Dilate(EdgeGraph(connectivity), isNear, rings);
  std::vector<char> faces(connectivity.NumberOfFaces(), 0);
  for (int v = 0; v < connectivity.NumberOfVertices(); ++v)
  {
    for (const int face : isNear[v] ? connectivity.FacesOfVertex(v) : IndexRange(nullptr, nullptr))
    {
      faces[face] = 1;
    }
  }
  return faces;
}
} // namespace shapeton
