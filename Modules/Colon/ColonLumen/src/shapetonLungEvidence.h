#ifndef shapetonLungEvidence_h
#define shapetonLungEvidence_h

#include "shapetonColonVolume.h"
#include "shapetonGasPieces.h"

#include <vector>

namespace shapeton
{
/** \brief Absolute measures that distinguish lung from the gas of a bowel.
 *
 * Gas in a bowel has the HU of room air up to the thin wall. Lung is uniformly denser than air and contains vessels,
 * whose cross sections are tissue islands in axial slices. */
struct LungEvidence
{
  double excess{ 0.0 };     ///< HU above room air: median over blocks of 5 mm inside the piece
  double parenchyma{ 0.0 }; ///< fraction of parenchyma blocks in and within 10 mm of the piece, 0 to 1
  double vessels{ 0.0 };    ///< cross sections of vessels per 100 cm^2 of the piece in axial slices

  bool
  IsLung() const;
  /** Whether the piece is certainly lung and not, for example, a foam table or a blanket. */
  bool
  IsVascularLung() const;
};

/** HU of air outside the body, clamped to [-1000, -950], since scanners may truncate lower values; -1000 if not in the
 * image. */
double
RoomAir(const ColonGrid & grid, const VoxelValues & hu, const GasOfVolume & gas);

/** \class LungSearch
 * \brief Measures LungEvidence for the pieces of gas in a volume. */
class LungSearch
{
public:
  /** `tissue` and `noise`: the mode of soft tissue and the standard deviation of its noise, HU. The references must
   * outlive this object. */
  LungSearch(const ColonGrid & grid, const VoxelValues & hu, const GasOfVolume & gas, double tissue, double noise);

  LungEvidence
  Measure(int piece) const;

private:
  struct Shares;

  Shares
  SharesOf(int piece) const;
  bool
  IsParenchyma(std::size_t block) const;
  double
  VesselsIn(int piece) const;

  const ColonGrid &   m_Grid;
  const VoxelValues & m_HU;
  const GasOfVolume & m_Gas;
  double              m_Air;
  double              m_Contrast; ///< between tissue and air, HU
  double              m_Noise;
  VoxelBlocks         m_Blocks;
  std::vector<char>   m_IsOutside; ///< blocks that contain air outside the body
};
} // namespace shapeton

#endif
