#ifndef shapetonTubeCut_h
#define shapetonTubeCut_h

#include "shapetonConformalTube.h"

#include <functional>

namespace shapeton
{
/** For each vertex its neighbours with the edges to them. */
class EdgeGraph
{
public:
  struct Step
  {
    int vertex;
    int edge;
  };
  EdgeGraph() = default;
  explicit EdgeGraph(const SurfaceConnectivity & connectivity);
  const Step *
  begin(int vertex) const
  {
    return m_Steps.data() + m_Begin[vertex];
  }
  const Step *
  end(int vertex) const
  {
    return m_Steps.data() + m_Begin[vertex + 1];
  }
  int
  NumberOfVertices() const
  {
    return static_cast<int>(m_Begin.size()) - 1;
  }

private:
  std::vector<int>  m_Begin;
  std::vector<Step> m_Steps;
};

/** The cheapest path from a vertex of the first loop to one of the second; all others of it lie inside. Of equal paths
 * the one that vertices with less indices come to first. Costs are positive; edges of infinite cost are left out, and
 * the path is empty where there is none without them. */
std::vector<int>
CheapestPath(const EdgeGraph & graph, const TubeEnds & ends, const Eigen::VectorXd & costs);

/** A path from the first loop along which u grows, by the steepest edge at each vertex; empty where u has a maximum on
 * the way. */
std::vector<int>
AscendingPath(const EdgeGraph & graph, const TubeEnds & ends, const Eigen::VectorXd & u);

/** The length of the shortest path of edges from each vertex to one of the sources. */
Eigen::VectorXd
DistancesAlongEdges(const EdgeGraph & graph, const Eigen::VectorXd & lengths, const std::vector<int> & sources);

/** Marks also the vertices within so many rings of marked ones. */
void
Dilate(const EdgeGraph & graph, std::vector<char> & isMarked, int rings);

/** The multiplicity of each vertex as a saddle: 0 for a regular one, -1 for an extremum; 0 on boundaries. Equal values
 * are told apart by the indices. */
std::vector<int>
SaddleMultiplicities(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const Eigen::VectorXd & u);

/** Distances from a curve in space, measured along the edges from the vertices next to it. Throws InputError where
 * most of the curve is farther than 10 mm from the surface. */
Eigen::VectorXd
DistancesFromCurve(const SurfaceMesh &                  mesh,
                   const EdgeGraph &                    graph,
                   const Eigen::VectorXd &              lengths,
                   const std::vector<Eigen::Vector3d> & curve);
} // namespace shapeton

#endif
