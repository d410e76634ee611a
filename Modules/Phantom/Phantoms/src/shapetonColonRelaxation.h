#ifndef shapetonColonRelaxation_h
#define shapetonColonRelaxation_h

#include "shapetonColonPath.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** \class ColonRelaxation
 * \brief Relaxes a chain of nodes inside the abdomen: preserves lengths, limits curvature and separates stretches.
 *
 * Position based dynamics (Mueller et al. 2007): constraints are projected repeatedly in a fixed order. Two nodes must
 * be at least as far apart as on a circle of the minimum radius of the tube; this rule limits bends and separates
 * stretches. */
class ColonRelaxation
{
public:
  /** `radius` is the lumen radius at each node, mm. The nodes are also the rest positions. */
  ColonRelaxation(const ColonPath & path, const std::vector<double> & radius);

  /** Mobility of each node, 0 (fixed) to 1 (free); default 0.5. */
  void
  SetMobility(const std::vector<double> & mobility)
  {
    m_Mobility = mobility;
  }

  void
  Run(int rounds);

  /** A ball that nodes avoid with the bulging tube around them. */
  struct Obstacle
  {
    Eigen::Vector3d center;
    double          radius; ///< mm, including walls
  };

  void
  SetObstacles(const std::vector<Obstacle> & obstacles)
  {
    m_Obstacles = obstacles;
  }

  /** Moves the first nodes to these points and fixes them; by default, the first five nodes are fixed. */
  void
  Hold(const std::vector<Eigen::Vector3d> & points);

  /** Reserves `room` mm around this node and two neighbors on each side for attached structures. Call before searching
   * for contacts; the search excludes these nodes. */
  void
  LeaveRoomAt(int node, double room);

  /** Up to `number` pairs of closest stretches; the pairs are far apart from each other. */
  std::vector<ColonPath::Contact>
  FindContacts(int number) const;

  /** Adds contact constraints for these pairs. */
  void
  DrawTogether(const std::vector<ColonPath::Contact> & contacts);

  const std::vector<Eigen::Vector3d> &
  GetNodes() const
  {
    return m_Nodes;
  }

private:
  void
  PullToAnchors();
  void
  Unbend();
  void
  OpenBends();
  void
  PushApart();
  void
  PullContacts();
  void
  AvoidObstacles();
  void
  Confine();
  void
  KeepLengths();
  double
  LeastDistance(int i, int j) const;

  std::vector<Eigen::Vector3d>    m_Nodes;
  std::vector<Eigen::Vector3d>    m_Anchors;
  std::vector<double>             m_Material;
  std::vector<double>             m_Radius;
  std::vector<double>             m_Mobility;
  std::size_t                     m_Held; ///< number of fixed nodes
  std::vector<Obstacle>           m_Obstacles;
  std::vector<ColonPath::Contact> m_Contacts;
  Eigen::MatrixXd                 m_Slack;
};
} // namespace shapeton

#endif
