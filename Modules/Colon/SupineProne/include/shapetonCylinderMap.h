#ifndef shapetonCylinderMap_h
#define shapetonCylinderMap_h

#include "shapetonColonCylinder.h"

#include <optional>

namespace shapeton
{
/** Nodes of a map between cylinders: rows at equal steps along the source, columns at equal angles from turn 0.
 * \ingroup ShapetonSupineProne */
struct CylinderNodes
{
  double begin{ 0.0 };
  double step{ 1.0 };
  /** Image of each node: mm along the target, and turns, unwrapped along rows and columns. */
  Eigen::MatrixXd s;
  Eigen::MatrixXd turn;

  int
  Rows() const
  {
    return static_cast<int>(s.rows());
  }
  int
  Angles() const
  {
    return static_cast<int>(s.cols());
  }
  /** Image of a node; the turn of column Angles() is greater by 1 than that of column 0. */
  CylinderPlace
  At(int row, int angle) const
  {
    const int around = angle / this->Angles();
    return { s(row, angle % this->Angles()), turn(row, angle % this->Angles()) + around };
  }
};

/** \class CylinderMap
 * \brief A piecewise linear map between two cylinders, and its inverse.
 *
 * Each cell is split along its diagonal. Beyond the ends the map is a shift along the colon. It is a bijection if no
 * triangle is flipped; see Flips(). Thread-safe.
 * \ingroup ShapetonSupineProne */
class ShapetonSupineProne_EXPORT CylinderMap
{
public:
  CylinderMap() = default;
  /** Requires at least two rows and three angles. */
  explicit CylinderMap(CylinderNodes nodes);

  CylinderPlace
  Forward(const CylinderPlace & place) const;
  /** Inverse map, with the turn in [0, 1); may be empty if the map is not a bijection. */
  std::optional<CylinderPlace>
  Inverse(const CylinderPlace & place) const;
  /** Number of flipped or degenerate triangles. */
  int
  Flips() const;
  /** The original nodes. */
  const CylinderNodes &
  Nodes() const
  {
    return m_Nodes;
  }

private:
  void
  MakeBins();
  std::optional<CylinderPlace>
  InverseOnTriangle(int triangle, const CylinderPlace & place) const;

  CylinderNodes                 m_Nodes;
  CylinderNodes                 m_Extended; ///< with an additional row far beyond each end
  std::vector<std::vector<int>> m_Bins;
  double                        m_BinBegin{ 0.0 };
  int                           m_BinRows{ 0 };
};
} // namespace shapeton

#endif
