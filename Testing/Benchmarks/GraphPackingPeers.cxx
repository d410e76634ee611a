#include "GraphPackingPeers.h"
#include "Times.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unordered_map>

namespace peers
{
namespace
{
using shapeton::CombinatorialMap;
using Triangle = std::array<int, 3>;

constexpr double pi = 3.14159265358979323846;
constexpr double wanted = 1e-10;
constexpr double mostSeconds = 60.0;

/** Two triangles of a square, split by a pseudo-random diagonal. */
void
AddSquare(int p, int q, int r, int s, unsigned int & state, std::vector<Triangle> & triangles)
{
  state = state * 1664525U + 1013904223U;
  if (state >> 31)
  {
    triangles.push_back({ p, q, r });
    triangles.push_back({ p, r, s });
  }
  else
  {
    triangles.push_back({ p, q, s });
    triangles.push_back({ q, r, s });
  }
}

CombinatorialMap
MapOf(int nodes, const std::vector<Triangle> & triangles)
{
  std::unordered_map<long long, int> halfEdge;
  std::vector<std::array<int, 2>>    edges;
  const auto                         key = [nodes](int a, int b) { return static_cast<long long>(a) * nodes + b; };
  for (const Triangle & t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto twin = halfEdge.find(key(t[(k + 1) % 3], t[k]));
      if (twin == halfEdge.end())
      {
        halfEdge[key(t[k], t[(k + 1) % 3])] = static_cast<int>(2 * edges.size());
        edges.push_back({ t[k], t[(k + 1) % 3] });
      }
      else
      {
        const int h = twin->second ^ 1;
        halfEdge[key(t[k], t[(k + 1) % 3])] = h;
      }
    }
  }
  std::vector<int> next(2 * edges.size());
  for (const Triangle & t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      next[halfEdge[key(t[k], t[(k + 1) % 3])]] = halfEdge[key(t[k], t[(k + 2) % 3])];
    }
  }
  return { nodes, edges, next };
}

/** All circles in one list, nodes first, each with its orthogonal circles. */
struct Packing
{
  Packing(const CombinatorialMap & map, const shapeton::CirclesAtInfinity & infinite)
    : neighbors(map.Nodes() + map.Faces())
    , radius(neighbors.size(), 1.0)
    , lines(neighbors.size(), 0)
    , isLine(radius.size(), 0)
  {
    for (int node = 0; node < map.Nodes(); ++node)
    {
      isLine[node] = infinite.lineNodes[node];
    }
    for (int face = 0; face < map.Faces(); ++face)
    {
      isLine[map.Nodes() + face] = infinite.lineFaces[face];
    }
    for (int h = 0; h < map.HalfEdges(); ++h)
    {
      const int node = map.Node(h);
      const int face = map.Nodes() + map.Face(h);
      this->Meet(node, face);
      this->Meet(face, node);
    }
  }
  void
  Meet(int one, int other)
  {
    if (isLine[other])
    {
      ++lines[one];
    }
    else
    {
      neighbors[one].push_back(other);
    }
  }
  double
  Angle(std::size_t i) const
  {
    double angle = pi * lines[i];
    for (const int j : neighbors[i])
    {
      angle += 2.0 * std::atan(radius[j] / radius[i]);
    }
    return angle;
  }

  std::vector<std::vector<int>> neighbors;
  std::vector<double>           radius;
  std::vector<int>              lines;
  std::vector<char>             isLine;
};

/** Returns the largest curvature encountered. */
double
Sweep(Packing & packing)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < packing.radius.size(); ++i)
  {
    if (packing.isLine[i])
    {
      continue;
    }
    const double fixed = pi * packing.lines[i];
    const double angle = packing.Angle(i);
    const double each = 2.0 * packing.neighbors[i].size();
    largest = std::max(largest, std::abs(2.0 * pi - angle));
    packing.radius[i] *= std::tan((angle - fixed) / each) / std::tan((2.0 * pi - fixed) / each);
  }
  return largest;
}

double
Flow(Packing & packing)
{
  double              largest = 0.0;
  double              stiffness = 0.0;
  std::vector<double> curvature(packing.radius.size(), 0.0);
  for (std::size_t i = 0; i < packing.radius.size(); ++i)
  {
    if (packing.isLine[i])
    {
      continue;
    }
    double own = 0.0;
    for (const int j : packing.neighbors[i])
    {
      const double a = packing.radius[i];
      const double b = packing.radius[j];
      own += 2.0 * a * b / (a * a + b * b);
    }
    stiffness = std::max(stiffness, own);
    curvature[i] = 2.0 * pi - packing.Angle(i);
    largest = std::max(largest, std::abs(curvature[i]));
  }
  for (std::size_t i = 0; i < packing.radius.size(); ++i)
  {
    packing.radius[i] *= std::exp(-curvature[i] / stiffness); // eigenvalues are below twice the stiffness
  }
  return largest;
}
} // namespace

CombinatorialMap
GridOnSphere(int side)
{
  std::vector<Triangle> triangles;
  unsigned int          state = 1;
  const int             apex = side * side;
  const auto            at = [side](int i, int j) { return i * side + j; };
  for (int i = 0; i + 1 < side; ++i)
  {
    for (int j = 0; j + 1 < side; ++j)
    {
      AddSquare(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), state, triangles);
    }
    triangles.push_back({ at(i + 1, 0), at(i, 0), apex });
    triangles.push_back({ at(i, side - 1), at(i + 1, side - 1), apex });
    triangles.push_back({ at(0, i), at(0, i + 1), apex });
    triangles.push_back({ at(side - 1, i + 1), at(side - 1, i), apex });
  }
  return MapOf(apex + 1, triangles);
}

CombinatorialMap
GridOnTorus(int side)
{
  std::vector<Triangle> triangles;
  unsigned int          state = 1;
  const auto            at = [side](int i, int j) { return (i % side) * side + j % side; };
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      AddSquare(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), state, triangles);
    }
  }
  return MapOf(side * side, triangles);
}

shapeton::CirclesAtInfinity
CirclesThroughFirstEdge(const CombinatorialMap & map)
{
  shapeton::CirclesAtInfinity infinite;
  infinite.lineNodes.assign(map.Nodes(), 0);
  infinite.lineFaces.assign(map.Faces(), 0);
  const int last = 2 * map.Edges() - 2; // adjacent to the node that closes the grid
  for (int h = last; h < last + 2; ++h)
  {
    infinite.lineNodes[map.Node(h)] = 1;
    infinite.lineFaces[map.Face(h)] = 1;
  }
  return infinite;
}

PeerRun
RunPeer(const CombinatorialMap & map, const shapeton::CirclesAtInfinity & infinite, Method method)
{
  Packing         packing(map, infinite);
  PeerRun         run;
  double          middleResidual = 0.0;
  double          middleSteps = 0.0;
  const Stopwatch watch;
  do
  {
    run.residual = method == Method::ThurstonSweep ? Sweep(packing) : Flow(packing);
    run.steps += 1.0;
    run.seconds = watch.Seconds();
    if (run.seconds > 0.5 * mostSeconds && middleSteps == 0.0)
    {
      middleResidual = run.residual;
      middleSteps = run.steps;
    }
  } while (run.residual > wanted && run.seconds < mostSeconds);
  if (run.residual > wanted)
  {
    const double rate = std::log(middleResidual / run.residual) / (run.steps - middleSteps);
    const double more = std::log(run.residual / wanted) / rate;
    run.seconds *= 1.0 + more / run.steps;
    run.steps += more;
    run.isExtrapolated = true;
  }
  return run;
}

namespace
{
using Point = std::array<double, 2>;

double
Orientation(const Point & a, const Point & b, const Point & c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

long
CrossingsOf(const shapeton::Graph & graph, const std::vector<Point> & places)
{
  long crossings = 0;
  for (std::size_t i = 0; i < graph.edges.size(); ++i)
  {
    const auto & [a, b] = graph.edges[i];
    for (std::size_t j = 0; j < i; ++j)
    {
      const auto & [c, d] = graph.edges[j];
      if (a == c || a == d || b == c || b == d)
      {
        continue;
      }
      crossings += Orientation(places[a], places[b], places[c]) * Orientation(places[a], places[b], places[d]) < 0.0 &&
                   Orientation(places[c], places[d], places[a]) * Orientation(places[c], places[d], places[b]) < 0.0;
    }
  }
  return crossings;
}
} // namespace

SfdpRun
RunSfdp(const shapeton::Graph & graph, bool countsCrossings)
{
  SfdpRun run;
  if (std::system("command -v sfdp > /dev/null") != 0)
  {
    return run;
  }
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string           dot = folder / "GraphEmbeddingBenchmark.dot";
  const std::string           plain = folder / "GraphEmbeddingBenchmark.plain";
  {
    std::ofstream file(dot);
    file << "graph {\n";
    for (int node = 0; node < graph.nodes; ++node)
    {
      file << node << ";\n";
    }
    for (const auto & [a, b] : graph.edges)
    {
      file << a << " -- " << b << ";\n";
    }
    file << "}\n";
  }
  const Stopwatch watch;
  if (std::system(("sfdp -Tplain " + dot + " > " + plain + " 2> /dev/null").c_str()) != 0)
  {
    return run;
  }
  run.seconds = watch.Seconds();
  run.places.resize(graph.nodes);
  std::ifstream file(plain);
  std::string   line;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string        kind;
    int                node = 0;
    Point              place{};
    if (words >> kind && kind == "node" && words >> node >> place[0] >> place[1])
    {
      run.places[node] = place;
    }
  }
  run.crossings = countsCrossings ? CrossingsOf(graph, run.places) : 0;
  std::filesystem::remove(dot);
  std::filesystem::remove(plain);
  return run;
}
} // namespace peers
