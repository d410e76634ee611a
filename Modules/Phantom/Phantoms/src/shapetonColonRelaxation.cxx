#include "shapetonColonRelaxation.h"

#include "shapetonColonAnatomy.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
// Margins for bulging haustra and wall thickness.
constexpr double c_Bulge = 1.06;
constexpr double c_Septum = 6.0;
// Maximum required distance between the centerlines of two stretches.
constexpr double c_FarApart = 120.0;
// The canal and the start of the ampulla are fixed.
constexpr std::size_t c_Held = 5;
// Distance (mm) below which the direction from one point to the other is undefined.
constexpr double c_SamePoint = 1e-6;
// Lower and upper end (mm) of the space for the colon.
constexpr double c_LowestWall = -132.0;
constexpr double c_HighestWall = 158.0;
// Numbers of nodes, about 10 mm apart: neighbors of the ileum, and the shortest way along the colon between two
// stretches that touch.
constexpr int c_IleumNeighbors = 12;
constexpr int c_BetweenContacts = 15;
} // namespace

ColonRelaxation::ColonRelaxation(const ColonPath & path, const std::vector<double> & radius)
  : m_Nodes(path.nodes)
  , m_Anchors(path.nodes)
  , m_Material(path.material)
  , m_Radius(radius)
  , m_Mobility(path.nodes.size(), 0.5)
  , m_Held(c_Held)
  , m_Slack(Eigen::MatrixXd::Zero(path.nodes.size(), path.nodes.size()))
{}

void
ColonRelaxation::Run(int rounds)
{
  // Finally, only hard constraints are active.
  const int pulled = 4 * rounds / 5;
  for (int round = 0; round < rounds; ++round)
  {
    if (round < pulled)
    {
      this->PullToAnchors();
    }
    this->Unbend();
    this->PullContacts();
    this->PushApart();
    this->AvoidObstacles();
    this->Confine();
    this->KeepLengths();
    for (int pass = 0; pass < 4; ++pass)
    {
      this->OpenBends();
    }
  }
}

void
ColonRelaxation::PullToAnchors()
{
  for (std::size_t i = 0; i < m_Nodes.size(); ++i)
  {
    const double strength = i < m_Held ? 1.0 : 0.03 * (1.0 - 0.95 * m_Mobility[i]);
    m_Nodes[i] += strength * (m_Anchors[i] - m_Nodes[i]);
  }
}

void
ColonRelaxation::Unbend()
{
  // Long spans suppress waves of several radii; the short span suppresses kinks.
  for (int span : { 4, 2, 1 })
  {
    const std::vector<Vector3d> old = m_Nodes;
    for (std::size_t i = span; i + span < old.size(); ++i)
    {
      if (i >= m_Held)
      {
        const double strength = span == 4 ? 0.03 : (span == 2 ? 0.1 : 0.4);
        m_Nodes[i] += strength * (0.5 * (old[i - span] + old[i + span]) - old[i]);
      }
    }
  }
}

// Limits bends to the width of the tube.
void
ColonRelaxation::OpenBends()
{
  for (std::size_t i = m_Held; i + 1 < m_Nodes.size(); ++i)
  {
    const Vector3d off = 0.5 * (m_Nodes[i - 1] + m_Nodes[i + 1]) - m_Nodes[i];
    const double   step = 0.5 * (m_Nodes[i + 1] - m_Nodes[i - 1]).norm();
    const double   allowed = 0.5 * step * step / (1.1 * m_Radius[i] + 2.0);
    const double   size = off.norm();
    if (size > allowed)
    {
      const Vector3d move = 0.5 * (1.0 - allowed / size) * off;
      m_Nodes[i] += move;
      m_Nodes[i - 1] -= (i - 1 < m_Held ? 0.0 : 0.5) * move;
      m_Nodes[i + 1] -= 0.5 * move;
    }
  }
}

double
ColonRelaxation::LeastDistance(int i, int j) const
{
  const double across = c_Bulge * (m_Radius[i] + m_Radius[j]) + c_Septum - m_Slack(i, j);
  const double along = m_Material[j] - m_Material[i];
  return across * std::sin(std::min(along / across, Pi / 2));
}

void
ColonRelaxation::PushApart()
{
  const int count = static_cast<int>(m_Nodes.size());
  const int held = static_cast<int>(m_Held);
  for (int i = 0; i < count; ++i)
  {
    for (int j = i + 3; j < count; ++j)
    {
      const Vector3d between = m_Nodes[j] - m_Nodes[i];
      const double   distance = between.norm();
      if (distance > c_FarApart || distance < c_SamePoint)
      {
        continue;
      }
      const double lacking = 0.97 * this->LeastDistance(i, j) - distance;
      if (lacking > 0)
      {
        const Vector3d push = (0.25 * lacking / distance) * between;
        m_Nodes[i] -= (i < held ? 0.0 : 1.0) * push;
        m_Nodes[j] += (j < held ? 0.0 : 1.0) * push;
      }
    }
  }
}

void
ColonRelaxation::AvoidObstacles()
{
  constexpr double share = 0.5; // of the missing distance, in a round
  for (std::size_t i = m_Held; i < m_Nodes.size(); ++i)
  {
    for (const Obstacle & obstacle : m_Obstacles)
    {
      const Vector3d off = m_Nodes[i] - obstacle.center;
      const double   distance = off.norm();
      const double   lacking = obstacle.radius + c_Bulge * m_Radius[i] - distance;
      if (lacking > 0.0 && distance > c_SamePoint)
      {
        m_Nodes[i] += (share * lacking / distance) * off;
      }
    }
  }
}

void
ColonRelaxation::Hold(const std::vector<Vector3d> & points)
{
  m_Held = points.size();
  std::copy(points.begin(), points.end(), m_Nodes.begin());
  std::copy(points.begin(), points.end(), m_Anchors.begin());
}

void
ColonRelaxation::PullContacts()
{
  for (const ColonPath::Contact & contact : m_Contacts)
  {
    const Vector3d between = m_Nodes[contact.second] - m_Nodes[contact.first];
    const double   over = between.norm() - this->LeastDistance(contact.first, contact.second);
    for (int k = -4; over > 0 && k <= 4; ++k)
    {
      const Vector3d pull = (0.1 * (1.0 - std::abs(k) / 5.0) * over / between.norm()) * between;
      m_Nodes[contact.first + k] += pull;
      m_Nodes[contact.second + k] -= pull;
    }
  }
}

void
ColonRelaxation::Confine()
{
  for (std::size_t i = m_Held; i < m_Nodes.size(); ++i)
  {
    Vector3d &   p = m_Nodes[i];
    const double r = c_Bulge * m_Radius[i] + 4.0;
    p.z() = std::clamp(p.z(), c_LowestWall + r, c_HighestWall - r);
    // The pelvis becomes narrower downward.
    const double across = 152.0 - 80.0 * std::clamp((-75.0 - p.z()) / 50.0, 0.0, 1.0);
    const double x = std::abs(p.x()) / (across - r);
    const double y = std::abs(p.y()) / (102.0 - r);
    const double outside = std::cbrt(x * x * x + y * y * y);
    if (outside > 1)
    {
      p.x() /= outside;
      p.y() /= outside;
    }
    const Vector3d spine = ColonAnatomy::SpineAxis(p.z());
    const Vector3d off = p - spine;
    const double   distance = off.norm();
    const double   least = (p.z() > -50.0 ? 31.0 : 18.0) + r;
    if (distance < least && distance > c_SamePoint)
    {
      p += 0.5 * (least / distance - 1.0) * off;
    }
  }
}

void
ColonRelaxation::KeepLengths()
{
  for (int pass = 0; pass < 3; ++pass)
  {
    for (std::size_t k = 1; k < m_Nodes.size(); ++k)
    {
      // Alternates between the two directions to avoid accumulating errors at one end.
      const std::size_t i = pass % 2 == 0 ? k : m_Nodes.size() - k;
      const Vector3d    edge = m_Nodes[i] - m_Nodes[i - 1];
      const double      length = edge.norm();
      const double      over = (length - (m_Material[i] - m_Material[i - 1])) / std::max(length, c_SamePoint);
      const double      first = i - 1 < m_Held ? 0.0 : 0.4;
      const double      second = i < m_Held ? 0.0 : 0.8 - first;
      m_Nodes[i - 1] += first * over * edge;
      m_Nodes[i] -= second * over * edge;
    }
  }
}

void
ColonRelaxation::LeaveRoomAt(int node, double room)
{
  const int count = static_cast<int>(m_Nodes.size());
  for (int i = std::max(0, node - 2); i <= std::min(count - 1, node + 2); ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      // Neighbors along the colon are separated by the bend constraint.
      if (std::abs(j - node) > c_IleumNeighbors)
      {
        m_Slack(i, j) = m_Slack(j, i) = -room;
      }
    }
  }
}

std::vector<ColonPath::Contact>
ColonRelaxation::FindContacts(int number) const
{
  struct Candidate
  {
    double gap;
    int    i;
    int    j;
  };
  std::vector<Candidate> candidates;
  const int              count = static_cast<int>(m_Nodes.size());
  for (int i = 12; i < count - 6; ++i)
  {
    for (int j = i + c_BetweenContacts; j < count - 6; ++j)
    {
      if (m_Slack(i, j) >= 0.0)
      {
        candidates.push_back({ (m_Nodes[j] - m_Nodes[i]).norm() - this->LeastDistance(i, j), i, j });
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate & a, const Candidate & b) {
    return a.gap != b.gap ? a.gap < b.gap : (a.i != b.i ? a.i < b.i : a.j < b.j);
  });
  std::vector<ColonPath::Contact> contacts;
  for (const Candidate & c : candidates)
  {
    const bool isApart = std::all_of(contacts.begin(), contacts.end(), [&c](const ColonPath::Contact & other) {
      return std::min(std::abs(c.i - other.first), std::abs(c.i - other.second)) > 8 &&
             std::min(std::abs(c.j - other.first), std::abs(c.j - other.second)) > 8;
    });
    if (isApart && static_cast<int>(contacts.size()) < number)
    {
      contacts.push_back({ c.i, c.j, 0.0 });
    }
  }
  return contacts;
}

void
ColonRelaxation::DrawTogether(const std::vector<ColonPath::Contact> & contacts)
{
  m_Contacts = contacts;
  const int count = static_cast<int>(m_Nodes.size());
  for (const ColonPath::Contact & contact : contacts)
  {
    for (int a = std::max(0, contact.first - 3); a <= std::min(count - 1, contact.first + 3); ++a)
    {
      for (int b = std::max(0, contact.second - 3); b <= std::min(count - 1, contact.second + 3); ++b)
      {
        // Slight overlap, so that bulging haustra flatten against each other.
        m_Slack(a, b) = m_Slack(b, a) = c_Septum + 1.0;
      }
    }
  }
}
} // namespace shapeton
