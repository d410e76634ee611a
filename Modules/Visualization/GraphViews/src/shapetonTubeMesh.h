#ifndef shapetonTubeMesh_h
#define shapetonTubeMesh_h

#include "shapetonHandleTube.h"

namespace shapeton
{
/** \brief Triangulation of a tube between two rims, with curves along it.
 *
 * Curves keep their order around every section. Their angles are interpolated between both rims without jumps, with
 * whole turns chosen to minimize the winding. */
class TubeMesh
{
public:
  /** `ends` are the vertices of each curve on both rims, ordered by increasing angle of the sections. Vertices and
   * triangles are appended to the lists. */
  TubeMesh(const std::vector<TubeSection> &        sections,
           const std::array<std::vector<int>, 2> & rims,
           const std::vector<std::array<int, 2>> & ends,
           std::vector<Eigen::Vector3d> &          vertices,
           std::vector<std::array<int, 3>> &       triangles);

  /** Vertices of each curve from the first rim to the second. */
  const std::vector<std::vector<int>> &
  Curves() const
  {
    return m_Curves;
  }
  /** Twist, in turns. */
  double
  Twist() const
  {
    return m_Twist;
  }

private:
  /** Vertices around a section by increasing angle, with the first one repeated at the end; `curves` are the indices of
   * the curves, followed by the last index. */
  struct Ring
  {
    std::vector<int>         vertices;
    std::vector<double>      angles;
    std::vector<std::size_t> curves;
  };
  Ring
  RimOf(const TubeSection & section, const std::vector<int> & rim, std::size_t side) const;
  void
  Unwind(const Ring & first, Ring & last);
  Ring
  RingBetween(const Ring & first, const Ring & last, const TubeSection & section, double t);
  void
  Join(const Ring & from, const Ring & to);

  const std::vector<std::array<int, 2>> & m_Ends;
  std::vector<Eigen::Vector3d> &          m_Vertices;
  std::vector<std::array<int, 3>> &       m_Triangles;
  std::vector<std::vector<int>>           m_Curves;
  double                                  m_Twist{ 0.0 };
};
} // namespace shapeton

#endif
