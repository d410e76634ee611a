#ifndef shapetonHeatHistogram_h
#define shapetonHeatHistogram_h

#include "ShapeDiffusionExport.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class HeatHistogram
 * \brief Counts of voxels by heat, one row for each recorded time step (dissertation 2.3.1, Figures 2.3 to 2.7).
 *
 * Heat lies in [0, 1]. Bins are fine: BinsPerOctave equal ones for each factor of two from 2^-Octaves to 1, so that
 * lines close to each other stay apart at any heat; bin 0 counts all heat below 2^-Octaves: the background, whose heat
 * has left through the boundary of the volume. Coarser pictures are made from these counts.
 *
 * \ingroup ShapeDiffusion
 */
class ShapeDiffusion_EXPORT HeatHistogram
{
public:
  static constexpr unsigned int BinsPerOctave = 256;
  static constexpr unsigned int Octaves = 16;
  static constexpr unsigned int NumberOfBins = BinsPerOctave * Octaves + 1;

  HeatHistogram() = default;
  explicit HeatHistogram(std::vector<std::uint64_t> timeSteps);

  /** The bin of a heat; values below 0 count as 0 and above 1 as 1. */
  static unsigned int
  BinOf(float heat);
  /** The least heat of a bin; LowerEdge(NumberOfBins) is 1. */
  static double
  LowerEdge(unsigned int bin);

  std::size_t
  GetNumberOfRows() const
  {
    return m_TimeSteps.size();
  }
  /** Ascending. */
  const std::vector<std::uint64_t> &
  GetTimeSteps() const
  {
    return m_TimeSteps;
  }
  std::uint32_t
  GetCount(std::size_t row, unsigned int bin) const
  {
    return m_Counts[row * NumberOfBins + bin];
  }
  const std::uint32_t *
  GetRow(std::size_t row) const
  {
    return m_Counts.data() + row * NumberOfBins;
  }

  /** Adds counts to a row; `counts` has NumberOfBins entries. */
  void
  AddToRow(std::size_t row, const std::uint32_t * counts);
  /** Counts `number` heats. */
  void
  AddToRow(std::size_t row, const float * heats, std::size_t number);

  /** Adds `number` heats to `counts`, which has NumberOfBins entries. */
  static void
  CountHeats(const float * heats, std::size_t number, std::uint32_t * counts);

  /** The equalisation of 2.3.1: the share, in [0, 1], of the counts without bin 0 that lie below the lower edge of each
   * bin, mean over the rows (NumberOfBins + 1 values, ascending from 0 to 1). One map for all rows, so that a converged
   * line stays at one place; each row counts the same, so that objects that keep their heat get room when the rest has
   * cooled. */
  std::vector<double>
  GetEqualization() const;

  bool
  operator==(const HeatHistogram & other) const
  {
    return m_TimeSteps == other.m_TimeSteps && m_Counts == other.m_Counts;
  }

private:
  std::vector<std::uint64_t> m_TimeSteps;
  std::vector<std::uint32_t> m_Counts;
};
} // namespace shapeton

#endif
