#ifndef shapetonHeatHistogram_h
#define shapetonHeatHistogram_h

#include "ShapetonHeatExport.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class HeatHistogram
 * \brief Counts of voxels by heat, one row for each recorded time step (dissertation 2.3.1, Figures 2.3 to 2.7).
 *
 * Heat is in [0, 1]. There are BinsPerOctave equal bins per factor of two from 2^-Octaves to 1, so close lines remain
 * distinct at any heat. Bin 0 counts all heat below 2^-Octaves: the background, which has lost its heat through the
 * boundary of the volume. Coarser pictures are derived from these counts.
 *
 * \ingroup ShapetonHeat */
class ShapetonHeat_EXPORT HeatHistogram
{
public:
  static constexpr unsigned int BinsPerOctave = 256;
  static constexpr unsigned int Octaves = 16;
  static constexpr unsigned int NumberOfBins = BinsPerOctave * Octaves + 1;

  HeatHistogram() = default;
  explicit HeatHistogram(std::vector<std::uint64_t> timeSteps);

  /** The bin of a heat value; clamped to [0, 1]. */
  static unsigned int
  BinOf(float heat);
  /** Lower edge of a bin; LowerEdge(NumberOfBins) is 1. */
  static double
  LowerEdge(unsigned int bin);

  std::size_t
  GetNumberOfRows() const
  {
    return m_TimeSteps.size();
  }
  /** Time steps of the rows, ascending. */
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
    this->RequireRow(row);
    return m_Counts.data() + row * NumberOfBins;
  }

  /** Adds counts to a row; `counts` has NumberOfBins entries. */
  void
  AddToRow(std::size_t row, const std::uint32_t * counts);
  /** Counts `number` heat values. */
  void
  AddToRow(std::size_t row, const float * heats, std::size_t number);

  /** Adds `number` heat values, `weight` times each, to `counts`, which has NumberOfBins entries. */
  static void
  CountHeats(const float * heats, std::size_t number, std::uint32_t * counts, std::uint32_t weight = 1);

  /** The equalization of 2.3.1: for each bin edge, the fraction of the counts below it, excluding bin 0, averaged over
   * the rows (NumberOfBins + 1 values, ascending from 0 to 1). All rows use the same map, so a converged line stays at
   * the same position. Rows have equal weight, which leaves space for objects that keep their heat while the rest
   * cools. */
  std::vector<double>
  GetEqualization() const;

  bool
  operator==(const HeatHistogram & other) const
  {
    return m_TimeSteps == other.m_TimeSteps && m_Counts == other.m_Counts;
  }

private:
  /** Throws ParameterError if the row does not exist. */
  void
  RequireRow(std::size_t row) const;

  std::vector<std::uint64_t> m_TimeSteps;
  std::vector<std::uint32_t> m_Counts;
};
} // namespace shapeton

#endif
