#ifndef shapetonColonRelaxation_h
#define shapetonColonRelaxation_h

#include "shapetonColonPath.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** \class ColonRelaxation
 * \brief Relaxes a chain of nodes: preserves lengths, limits curvature, separates stretches, keeps them inside the
 * abdomen.
 *
 * Position based dynamics (Mueller et al. 2007): each constraint moves the nodes just enough to satisfy it, in a
 * fixed order, repeatedly. Two nodes must be at least as far apart as on a circle of the tube's minimum radius;
 * this single rule keeps bends open and stretches apart. */
class ColonRelaxation
{
public:
  /** `radius` of the lumen at each node in mm. The nodes are also the rest positions. */
  ColonRelaxation(const ColonPath & path, const std::vector<double> & radius);

  /** 0 (fixed) to 1 (free), for each node; 0.5 by default. */
  void
  SetMobility(const std::vector<double> & mobility)
  {
    m_Mobility = mobility;
  }

  void
  Run(int rounds);

  /** Keeps the other stretches `room` mm farther from the nodes within two of this one, for structures that leave
   * the colon there. Call it before searching contacts: these nodes then have none. */
  void
  LeaveRoomAt(int node, double room);

  /** Up to `number` pairs of closest stretches, well separated from each other. */
  std::vector<ColonPath::Contact>
  FindContacts(int number) const;

  /** Makes these pairs touch from now on. */
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
  std::vector<ColonPath::Contact> m_Contacts;
  Eigen::MatrixXd                 m_Slack;
};
} // namespace shapeton

#endif
