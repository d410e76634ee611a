#ifndef shapetonColonFluid_h
#define shapetonColonFluid_h

#include "ShapetonPhantomsExport.h"
#include "shapetonColonAnatomy.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shapeton
{
/** A connected pool of tagged fluid with one level. \ingroup ShapetonPhantoms */
struct ColonPool
{
  double level;     ///< height of the fluid level: up * point, mm
  double bottom;    ///< height of the lowest point, mm
  double volume;    ///< ml
  double intensity; ///< mean, HU
  /** HU of the unmixed wedge at the bottom; 0 if there is none. */
  double wedge;
};

/** \class ColonFluid
 * \brief The tagged fluid in the lumen of a colon: pools with levels perpendicular to gravity.
 *
 * The lumen is sampled on a lattice. Slices of it by arc length are the nodes of a graph; the height of an edge is
 * that at which fluid passes from one slice to the other. Basins are merged in the order of these heights, and the
 * resulting tree is filled from its root: if the fluid of a node suffices to pass its ridge, it has one level, else
 * the ridge divides it. Thus no level is above a ridge that it has not passed, and no fluid is unsupported.
 *
 * The share of the lumen's volume is that of the parameters (error below 0.002 on the lattice). Basins below 2 ml
 * contain fluid only together with their neighbors. Fluid may fill a stretch up to its ceiling; the levels on both
 * sides of such a stretch have equal height.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT ColonFluid
{
public:
  /** The anatomy must outlive this object. */
  explicit ColonFluid(const ColonAnatomy & anatomy);

  /** Direction of gravity, a unit vector: that of the position, tilted by at most 1 degree. */
  const Eigen::Vector3d &
  Down() const
  {
    return m_Down;
  }

  /** Depth in mm of a point of the lumen below the fluid level of its stretch, negative above it; a large negative
   * value where there is no fluid. */
  double
  DepthBelowLevel(const Eigen::Vector3d & point, double arcLength) const;

  /** Intensity in HU of the fluid at a point of the lumen. */
  double
  Intensity(const Eigen::Vector3d & point, double arcLength) const;

  const std::vector<ColonPool> &
  Pools() const
  {
    return m_Pools;
  }

  /** The volume of the lumen, ml. */
  double
  LumenVolume() const
  {
    return m_LumenVolume;
  }

private:
  struct Wave
  {
    Eigen::Vector3d number;
    double          phase;
  };

  int
  BinOf(double arcLength) const;
  void
  MakeTexture();

  const ColonAnatomy &   m_Anatomy;
  Eigen::Vector3d        m_Down;
  double                 m_LumenVolume{ 0.0 };
  std::vector<int>       m_PoolOfBin; // -1 if there is no fluid
  std::vector<ColonPool> m_Pools;
  std::array<Wave, 8>    m_Waves;
};

/** Direction of gravity in a position, tilted by at most 1 degree depending on the seed. Throws ParameterError for
 * an unknown position. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT Eigen::Vector3d
                    GravityOf(const ColonPhantomParameters & parameters);
} // namespace shapeton

#endif
