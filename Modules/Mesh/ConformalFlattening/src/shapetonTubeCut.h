#ifndef shapetonTubeCut_h
#define shapetonTubeCut_h

#include "shapetonConformalTube.h"

namespace shapeton
{
/** Neighbors of each vertex, with the edges to them. */
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

/** The cheapest path from the first to the second loop, with all other vertices inside. Ties are broken by lower vertex
 * indices. Costs are positive; edges of infinite cost are excluded. Empty if no path exists. */
std::vector<int>
CheapestPath(const EdgeGraph & graph, const TubeEnds & ends, const Eigen::VectorXd & costs);

/** A steepest-ascent path of u from the first loop; empty if it ends at a maximum of u. */
std::vector<int>
AscendingPath(const EdgeGraph & graph, const TubeEnds & ends, const Eigen::VectorXd & u);

/** Shortest edge-path length from each vertex to the sources. */
Eigen::VectorXd
DistancesAlongEdges(const EdgeGraph & graph, const Eigen::VectorXd & lengths, const std::vector<int> & sources);

/** Dilates the marks by the given number of rings. */
void
Dilate(const EdgeGraph & graph, std::vector<char> & isMarked, int rings);

/** Saddle multiplicity of each vertex: 0 for a regular vertex, -1 for an extremum; 0 on boundaries. Ties are broken by
 * index. */
std::vector<int>
SaddleMultiplicities(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const Eigen::VectorXd & u);

/** Multiplies the costs of edges that are shortcuts through handles by a million, so that any detour is cheaper. These
 * are edges whose ends are farther apart along the centerline (point array arcLength) than 10 times the edge length. In
 * real colons with 2 mm edges, handles reach 40 times and more; edges inside sharp bends may also be affected. Does
 * nothing if the array is missing. \param lengths of the edges in space. */
void
AvoidShortcuts(const SurfaceMesh &         mesh,
               const SurfaceConnectivity & connectivity,
               const Eigen::VectorXd &     lengths,
               Eigen::VectorXd &           costs);

/** Distances from a curve in space, measured along edges from the vertices next to it. Throws InputError if most of the
 * curve is more than 10 mm from the surface. */
Eigen::VectorXd
DistancesFromCurve(const SurfaceMesh &                  mesh,
                   const EdgeGraph &                    graph,
                   const Eigen::VectorXd &              lengths,
                   const std::vector<Eigen::Vector3d> & curve);
} // namespace shapeton

#endif
