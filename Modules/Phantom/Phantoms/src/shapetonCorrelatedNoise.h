#ifndef shapetonCorrelatedNoise_h
#define shapetonCorrelatedNoise_h

#include "ShapetonPhantomsExport.h"

#include "itkImageRegion.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class CorrelatedNoise
 * \brief Gaussian noise of a CT volume, correlated between neighboring voxels.
 *
 * White noise from Philox is generated for each voxel of the grid and of one surrounding layer. It is filtered along
 * each axis by (a, 1, a) / sqrt(1 + 2 a^2). The correlation is 2 a / (1 + 2 a^2) between neighbors and a^2 / (1 + 2
 * a^2) at a distance of two voxels.
 *
 * The noise of a voxel depends only on its index.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT CorrelatedNoise
{
public:
  using RegionType = itk::ImageRegion<3>;

  /** `correlation` of neighbors along the three axes, each in [0, 0.7]. */
  CorrelatedNoise(std::uint64_t                 seed,
                  const RegionType &            grid,
                  double                        standardDeviation,
                  const std::array<double, 3> & correlation);

  /** Adds noise to the values of a region, first index fastest. */
  void
  AddTo(std::vector<float> & values, const RegionType & region) const;

private:
  std::uint64_t         m_Seed;
  RegionType            m_Grid;
  double                m_StandardDeviation;
  std::array<double, 3> m_Side;
};
} // namespace shapeton

#endif
