#include "shapetonColonSplitting.h"

#include "shapetonBoundaryLoops.h"
#include "shapetonConformalMap.h"
#include "shapetonJson.h"
#include "shapetonSurfaceCut.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace shapeton
{
namespace
{

/** The tube with its cut closed, and those arrays of the flat surface that remain valid. */
SurfaceMesh
WeldedSurface(const SurfaceMesh & flat, const ColonWallTube & tube)
{
  SurfaceMesh welded;
  welded.V = tube.Points();
  welded.F = tube.Faces();
  welded.cellArrays = flat.cellArrays;
  SurfaceArray arc{ "arcLength", SurfaceArray::ValueMatrix(tube.NumberOfVertices(), 1), false };
  for (int vertex = 0; vertex < tube.NumberOfVertices(); ++vertex)
  {
    arc.values(vertex, 0) = tube.ArcLength(vertex);
  }
  welded.pointArrays.push_back(arc);
  return welded;
}

/** Distance (mm) of each vertex from a taenia, limited to nearby vertices along the colon. */
std::vector<double>
DistancesFromTaenia(const SurfaceMesh & mesh, const ColonTaenia & taenia)
{
  constexpr double    reach = 60.0; // mm along the colon, since other loops may touch
  std::vector<double> distances(mesh.V.rows(), reach);
  for (Eigen::Index vertex = 0; vertex < mesh.V.rows(); ++vertex)
  {
    const double arc = mesh.pointArrays.back().values(vertex, 0);
    for (std::size_t i = 0; i < taenia.points.size(); ++i)
    {
      if (std::abs(taenia.arcLength[i] - arc) < reach)
      {
        distances[vertex] = std::min(distances[vertex], (taenia.points[i] - mesh.V.row(vertex).transpose()).norm());
      }
    }
  }
  return distances;
}

/** The minimal path along the taenia from one boundary to the other; only its ends are on the boundaries. The cost per
 * mm is 1 + (d / 5 mm)^2, where d is the distance from the taenia. */
std::vector<int>
CutBetween(const SurfaceMesh &         mesh,
           const SurfaceConnectivity & connectivity,
           const std::vector<int> &    from,
           const ColonTaenia &         taenia)
{
  const std::vector<double> distance = DistancesFromTaenia(mesh, taenia);
  std::vector<double>       cost(mesh.V.rows(), std::numeric_limits<double>::max());
  std::vector<int>          before(mesh.V.rows(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<char>                                              isStart(mesh.V.rows(), 0);
  for (const int vertex : from)
  {
    // The start of the path must also be close to the taenia.
    cost[vertex] = 4.0 * distance[vertex];
    isStart[vertex] = 1;
    queue.emplace(cost[vertex], vertex);
  }
  while (!queue.empty())
  {
    const auto [reached, vertex] = queue.top();
    queue.pop();
    if (reached > cost[vertex])
    {
      continue;
    }
    if (connectivity.IsBoundaryVertex(vertex) && !isStart[vertex])
    {
      std::vector<int> path;
      for (int at = vertex; at >= 0; at = before[at])
      {
        path.push_back(at);
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const int next : connectivity.NeighborsOfVertex(vertex))
    {
      const double far = 0.5 * (distance[vertex] + distance[next]) / 5.0;
      const double total = reached + (mesh.V.row(vertex) - mesh.V.row(next)).norm() * (1.0 + far * far);
      if (!isStart[next] && total < cost[next])
      {
        cost[next] = total;
        before[next] = vertex;
        queue.emplace(total, next);
      }
    }
  }
  return {};
}

/** The corners of the cut surface in boundary order: rectal, cecal, cecal, rectal. */
std::vector<int>
CornersOf(const CutSurface & cut, const std::vector<int> & path)
{
  const SurfaceConnectivity       connectivity(cut.mesh);
  const std::vector<BoundaryLoop> loops = BoundaryLoopsByLength(connectivity, cut.mesh.V);
  if (loops.size() != 1)
  {
    return {};
  }
  std::vector<int>  corners;
  std::vector<char> isFirst;
  for (const int vertex : loops[0].vertices)
  {
    const int source = cut.sourcePointId[vertex];
    if (source == path.front() || source == path.back())
    {
      corners.push_back(vertex);
      isFirst.push_back(source == path.front());
    }
  }
  for (int turn = 0; corners.size() == 4 && turn < 4; ++turn)
  {
    if (isFirst[0] && !isFirst[1] && !isFirst[2] && isFirst[3])
    {
      return corners;
    }
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    std::rotate(isFirst.begin(), isFirst.begin() + 1, isFirst.end());
  }
  return {};
}

/** The boundary nearer to the rectum. */
std::vector<int>
RectalLoop(const SurfaceMesh & tube, const std::vector<BoundaryLoop> & loops)
{
  const auto meanArc = [&](const BoundaryLoop & loop) {
    double sum = 0.0;
    for (const int vertex : loop.vertices)
    {
      sum += tube.pointArrays.back().values(vertex, 0);
    }
    return sum / static_cast<double>(loop.vertices.size());
  };
  return meanArc(loops[0]) <= meanArc(loops[1]) ? loops[0].vertices : loops[1].vertices;
}

ColonPiece
MakePiece(const SurfaceMesh & tube, const ColonTaenia & taenia, int segment, const Progress & progress)
{
  const std::string               name = "the " + NameOfSegment(segment);
  const SurfaceConnectivity       connectivity(tube);
  const std::vector<BoundaryLoop> loops = BoundaryLoopsByLength(connectivity, tube.V);
  if (connectivity.Components().size() != 1 || loops.size() != 2)
  {
    throw InputError(name + " is not a tube between its borders");
  }
  const std::vector<int> path = CutBetween(tube, connectivity, RectalLoop(tube, loops), taenia);
  if (path.size() < 2)
  {
    throw InputError("no path along the taenia was found through " + name);
  }
  const CutSurface     cut = CutAlongPaths(tube, connectivity, { path });
  ConformalMapSettings options;
  options.domain = ConformalDomain::Rectangle;
  options.progress = progress;
  options.corners = CornersOf(cut, path);
  if (options.corners.empty())
  {
    throw InputError(name + " does not have four corners after the cut along the taenia");
  }
  ConformalMap map = MapConformally(cut.mesh, options, name);
  ColonPiece   piece;
  piece.segment = segment;
  piece.name = NameOfSegment(segment);
  piece.modulusU = map.modulusU;
  piece.modulusV = map.modulusV;
  piece.flips = map.flips;
  piece.area = SurfaceArea(tube.V, tube.F);
  piece.width = std::sqrt(piece.area / std::sqrt(map.modulusU * map.modulusV));
  piece.height = piece.area / piece.width;
  piece.flat = std::move(map.flat);
  SurfaceArray corners{ CutCorners, SurfaceArray::ValueMatrix(4, 1), true };
  for (int corner = 0; corner < 4; ++corner)
  {
    corners.values(corner, 0) = map.corners[corner];
  }
  piece.flat.fieldArrays.push_back(corners);
  return piece;
}
} // namespace

ColonPieces
SplitColon(const SurfaceMesh & flat, const ColonLandmarks & landmarks, const Progress & progress)
{
  ColonPieces result;
  if (landmarks.taeniae.taeniae.empty())
  {
    result.warnings.push_back("the colon was not split: no taenia was found for the cut");
    return result;
  }
  const SurfaceMesh welded = WeldedSurface(flat, *landmarks.tube);
  for (int segment = 1; segment <= NumberOfColonSegments; ++segment)
  {
    const Progress part = progress.Part(NameOfSegment(segment),
                                        (segment - 1.0) / NumberOfColonSegments,
                                        static_cast<double>(segment) / NumberOfColonSegments);
    part(0.0);
    std::vector<int> faces;
    for (std::size_t face = 0; face < landmarks.segments.segmentOfFace.size(); ++face)
    {
      if (landmarks.segments.segmentOfFace[face] == segment)
      {
        faces.push_back(static_cast<int>(face));
      }
    }
    try
    {
      if (faces.empty())
      {
        throw InputError("the borders of the " + NameOfSegment(segment) + " are not known");
      }
      const SurfaceMesh tube = FacesOfSurface(welded, faces);
      result.pieces.push_back(MakePiece(tube, landmarks.taeniae.taeniae.front(), segment, part));
    }
    catch (const InputError & error)
    {
      result.warnings.push_back("segment-" + NameOfSegment(segment) + ".vtp could not be created: " + error.what());
    }
  }
  return result;
}

Json
ColonPiecesToJson(const ColonPieces & pieces)
{
  constexpr double perUnit = 1e5; // five decimal places
  const auto       rounded = [](double value) { return std::round(value * perUnit) / perUnit; };
  Json             list = Json::array();
  for (const ColonPiece & piece : pieces.pieces)
  {
    Json json;
    json["segment"] = piece.segment;
    json["name"] = piece.name;
    json["modulus"] = rounded(std::sqrt(piece.modulusU * piece.modulusV));
    json["modulusU"] = rounded(piece.modulusU);
    json["modulusV"] = rounded(piece.modulusV);
    json["width"] = rounded(piece.width);
    json["height"] = rounded(piece.height);
    json["area"] = rounded(piece.area);
    json["faces"] = piece.flat.NumberOfFaces();
    json["flips"] = piece.flips;
    list.push_back(json);
  }
  return list;
}
} // namespace shapeton
