#ifndef shapetonColonFluid_h
#define shapetonColonFluid_h

#include "ShapetonPhantomsExport.h"
#include "shapetonColonAnatomy.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shapeton
{
struct FluidPassage;
struct FluidPool;

/** A connected pool of tagged fluid with a common level. \ingroup ShapetonPhantoms */
struct ColonPool
{
  double level;     ///< height of the level (up * point), mm
  double bottom;    ///< height of the lowest point, mm
  double volume;    ///< ml
  double intensity; ///< mean, HU
  /** HU of the unmixed wedge at the bottom; 0 if absent. */
  double wedge;
};

/** A fluid level that falls along the colon, as during slow flow through a narrow stretch. \ingroup ShapetonPhantoms */
struct ShapetonPhantoms_EXPORT TiltedLevel
{
  double begin{ 0.0 }; ///< arc length (mm) from which the level of the pool falls
  double end{ 0.0 };   ///< arc length (mm) from which it is horizontal again; may be less than `begin`
  double slope{ 0.0 }; ///< mm per mm of arc length; 0 if absent

  /** Height (mm) by which the level at an arc length is below that of the pool. */
  double
  FallTo(double arcLength) const;
};

/** A small air-fluid level of a puddle. \ingroup ShapetonPhantoms */
struct SmallLevel
{
  Eigen::Vector3d position;  ///< center of the level, LPS mm
  double          area;      ///< mm^2, to about 10 %
  double          depth;     ///< mm, of the puddle
  double          arcLength; ///< mm
};

/** \class ColonFluid
 * \brief The tagged fluid in the lumen of a colon: pools with levels perpendicular to gravity.
 *
 * The lumen is sampled on a lattice. Slices by arc length are the nodes of a graph; the height of an edge is the level
 * at which fluid flows between two slices. Basins are merged in order of these heights, and the resulting tree is
 * filled from its root: if the fluid of a node exceeds its ridge, it has one level, otherwise the ridge divides it.
 * This guarantees physically consistent levels.
 *
 * The fluid fraction of the lumen volume matches the parameters (error below 0.002 on the lattice). Basins below 2 ml
 * contain fluid only together with their neighbors. Fluid may fill a stretch completely; the levels on both sides of
 * such a stretch are equal. The level of one pool may fall by some millimeters along a narrow stretch.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT ColonFluid
{
public:
  /** The anatomy must outlive this object. */
  explicit ColonFluid(const ColonAnatomy & anatomy);

  /** Unit vector of gravity for the position, tilted by at most 1 degree. */
  const Eigen::Vector3d &
  Down() const
  {
    return m_Down;
  }

  /** Depth (mm) of a point of the lumen below the fluid level of its stretch, negative above; a large negative value in
   * stretches without fluid. */
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

  /** Arc lengths (mm) of the ends of the stretch that is completely filled by fluid and below its level on both sides;
   * equal if there is no such stretch. */
  const std::array<double, 2> &
  FilledStretch() const
  {
    return m_FilledStretch;
  }

  const std::vector<SmallLevel> &
  SmallLevels() const
  {
    return m_SmallLevels;
  }

  const TiltedLevel &
  GetTiltedLevel() const
  {
    return m_TiltedLevel;
  }

  /** Volume of the lumen, ml. */
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
  void
  FillStretch(const std::vector<std::vector<float>> & heights,
              const std::vector<FluidPassage> &       passages,
              std::vector<FluidPool> &                pools);
  void
  TiltLevel(const std::vector<std::vector<float>> & heights);
  void
  AddSmallLevels(const std::vector<std::vector<float>> & heights);
  bool
  MayHoldPuddle(const std::vector<std::vector<float>> & heights, int slice) const;
  SmallLevel
  PuddleIn(int slice, const Eigen::Vector3d & center, double level) const;
  std::vector<bool>
  PlacesForTilt(const std::vector<std::vector<float>> & heights, int slices) const;

  const ColonAnatomy &    m_Anatomy;
  Eigen::Vector3d         m_Down;
  double                  m_LumenVolume{ 0.0 };
  std::vector<int>        m_PoolOfBin; // -1 without fluid
  std::vector<ColonPool>  m_Pools;
  std::array<double, 2>   m_FilledStretch{ { 0.0, 0.0 } };
  TiltedLevel             m_TiltedLevel;
  int                     m_TiltedPool{ -1 };
  std::vector<SmallLevel> m_SmallLevels;
  std::array<Wave, 8>     m_Waves;
};

/** Direction of gravity in a position, tilted by at most 1 degree depending on the seed. Throws ParameterError for
 * an unknown position. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT Eigen::Vector3d
                        GravityOf(const ColonPhantomParameters & parameters);
} // namespace shapeton

#endif
