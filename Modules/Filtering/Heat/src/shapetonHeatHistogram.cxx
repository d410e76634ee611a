#include "shapetonHeatHistogram.h"
#include "shapetonDiffusionKernels.h"
#include "shapetonExceptions.h"
#include "shapetonKernelSets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
HeatHistogram::HeatHistogram(std::vector<std::uint64_t> timeSteps)
  : m_TimeSteps(std::move(timeSteps)), m_Counts(m_TimeSteps.size() * NumberOfBins, 0)
{
  RequireParameter(std::is_sorted(m_TimeSteps.begin(), m_TimeSteps.end()),
                   "the time steps of a heat histogram must be ascending");
}

void
HeatHistogram::RequireRow(std::size_t row) const
{
  RequireParameter(row < m_TimeSteps.size(),
                   "the heat histogram has " + std::to_string(m_TimeSteps.size()) + " rows, but row " +
                     std::to_string(row) + " is asked for; set the histogram steps of the run");
}

unsigned int
HeatHistogram::BinOf(float heat)
{
  unsigned short bin = 0;
  BestKernels<DiffusionKernels::Set>().BinHeats(&heat, &bin, 1);
  return bin;
}

double
HeatHistogram::LowerEdge(unsigned int bin)
{
  if (bin == 0)
  {
    return 0.0;
  }
  const unsigned int octave = (bin - 1) / BinsPerOctave;
  const double       within = static_cast<double>((bin - 1) % BinsPerOctave) / BinsPerOctave;
  return std::ldexp(1.0 + within, static_cast<int>(octave) - static_cast<int>(Octaves));
}

void
HeatHistogram::AddToRow(std::size_t row, const std::uint32_t * counts)
{
  this->RequireRow(row);
  std::uint32_t * const target = m_Counts.data() + row * NumberOfBins;
  for (unsigned int bin = 0; bin < NumberOfBins; ++bin)
  {
    target[bin] += counts[bin];
  }
}

void
HeatHistogram::AddToRow(std::size_t row, const float * heats, std::size_t number)
{
  this->RequireRow(row);
  CountHeats(heats, number, m_Counts.data() + row * NumberOfBins);
}

void
HeatHistogram::CountHeats(const float * heats, std::size_t number, std::uint32_t * counts, std::uint32_t weight)
{
  constexpr std::size_t block = 512;
  const auto &          kernels = BestKernels<DiffusionKernels::Set>();
  unsigned short        bins[block];
  for (std::size_t start = 0; start < number; start += block)
  {
    const std::size_t length = std::min(block, number - start);
    kernels.BinHeats(heats + start, bins, length);
    for (std::size_t i = 0; i < length; ++i)
    {
      counts[bins[i]] += weight;
    }
  }
}

std::vector<double>
HeatHistogram::GetEqualization() const
{
  std::vector<double> below(NumberOfBins + 1, 0.0);
  for (std::size_t row = 0; row < this->GetNumberOfRows(); ++row)
  {
    const std::uint32_t * const counts = this->GetRow(row);
    const double                total = std::accumulate(counts + 1, counts + NumberOfBins, 0.0);
    for (unsigned int bin = 1; bin < NumberOfBins && total > 0.0; ++bin)
    {
      below[bin + 1] += counts[bin] / total;
    }
  }
  for (unsigned int bin = 1; bin <= NumberOfBins; ++bin)
  {
    below[bin] += below[bin - 1];
  }
  const double total = below.back();
  for (unsigned int bin = 0; bin <= NumberOfBins; ++bin)
  {
    below[bin] = total > 0.0 ? below[bin] / total : static_cast<double>(bin) / NumberOfBins;
  }
  return below;
}
} // namespace shapeton
