#ifndef shapetonColonFluid_h
#define shapetonColonFluid_h

#include "ColonPhantomExport.h"
#include "shapetonColonAnatomy.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shapeton
{
/** A connected piece of tagged fluid under one level. \ingroup ColonPhantom */
struct ColonPool
{
  double level;     ///< height of the level: up * point, mm
  double bottom;    ///< height of its lowest point, mm
  double volume;    ///< ml
  double intensity; ///< mean, HU
  /** HU of the unmixed wedge at the bottom; 0 where there is none. */
  double wedge;
};

/** \class ColonFluid
 * \brief The tagged fluid in the lumen of a colon: pools under levels perpendicular to gravity.
 *
 * The lumen is sampled on a lattice. Slices of it by arc length are the nodes of a graph; an edge has the height at
 * which fluid passes from one slice to the other. Basins grow together in the order of these heights; the resulting
 * tree is filled from its root: where the fluid of a node suffices to pass its ridge, all of it has one level, else the
 * ridge divides it. So no level lies above a ridge that it has not passed, and no fluid stands free.
 *
 * The share of the lumen's volume is that of the parameters (error below 0.002 on the lattice). Basins below 2 ml hold
 * fluid only together with their neighbours. Fluid may fill a stretch up to its ceiling; gas on both sides of such a
 * stretch has levels of equal height.
 *
 * \ingroup ColonPhantom
 */
class ColonPhantom_EXPORT ColonFluid
{
public:
  /** The anatomy has to outlive this object. */
  explicit ColonFluid(const ColonAnatomy & anatomy);

  /** The direction of gravity, a unit vector: that of the position, tilted by at most 1 degree. */
  const Eigen::Vector3d &
  Down() const
  {
    return m_Down;
  }

  /** How far in mm a point of the lumen lies below the level of its stretch, negative above it; far below zero where
   * there is no fluid. */
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
  std::vector<int>       m_PoolOfBin; // -1 without fluid
  std::vector<ColonPool> m_Pools;
  std::array<Wave, 8>    m_Waves;
};

/** The direction of gravity in a position, tilted by at most 1 degree in a way that the seed fixes. Throws
 * ParameterError for another position. \ingroup ColonPhantom */
ColonPhantom_EXPORT Eigen::Vector3d
                    GravityOf(const ColonPhantomParameters & parameters);
} // namespace shapeton

#endif
