#include "shapetonHeatAxis.h"

#include <cmath>

#include "shapetonColorMap.h"

#include <algorithm>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** From the first to the last bin with a count in any row, excluding the background. */
HeatRange
RangeOf(const HeatHistogram & histogram)
{
  unsigned int first = HeatHistogram::NumberOfBins;
  unsigned int last = 0;
  for (std::size_t row = 0; row < histogram.GetNumberOfRows(); ++row)
  {
    for (unsigned int bin = 1; bin < HeatHistogram::NumberOfBins; ++bin)
    {
      if (histogram.GetCount(row, bin) > 0)
      {
        first = std::min(first, bin);
        last = std::max(last, bin);
      }
    }
  }
  if (last == 0)
  {
    return { HeatHistogram::LowerEdge(1), 1.0 };
  }
  return { HeatHistogram::LowerEdge(first), HeatHistogram::LowerEdge(last + 1) };
}

/** Continuous bin coordinate: bin k covers [k, k + 1), linear in heat inside. */
double
BinCoordinateOf(double heat)
{
  const unsigned int bin = HeatHistogram::BinOf(static_cast<float>(heat));
  const double       lower = HeatHistogram::LowerEdge(bin);
  const double       upper = HeatHistogram::LowerEdge(bin + 1);
  return bin + std::clamp((heat - lower) / (upper - lower), 0.0, 1.0);
}

double
HeatOfBinCoordinate(double coordinate)
{
  const auto   bin = std::min(static_cast<unsigned int>(coordinate), HeatHistogram::NumberOfBins - 1);
  const double lower = HeatHistogram::LowerEdge(bin);
  return lower + (coordinate - bin) * (HeatHistogram::LowerEdge(bin + 1) - lower);
}

bool
IsDefault(const HeatRange & range)
{
  return range.lower == 0.0 && range.upper == 0.0;
}
} // namespace

HeatAxis::HeatAxis(const HeatHistogram & histogram, HeatScale scale, const HeatRange & range)
  : m_Scale(scale), m_Range(IsDefault(range) ? RangeOf(histogram) : range), m_Shares(histogram.GetEqualization())
{
  if (!(m_Range.lower >= 0.0 && m_Range.lower < m_Range.upper && m_Range.upper <= 1.0))
  {
    throw std::invalid_argument("a heat range must satisfy 0 <= lower < upper <= 1");
  }
  if (scale == HeatScale::Normalized && IsDefault(range))
  {
    m_Range.lower = 0.0;
  }
  m_LowerShare = this->ShareBelow(m_Range.lower);
  m_UpperShare = this->ShareBelow(m_Range.upper);
  if (m_UpperShare > m_LowerShare)
  {
    return;
  }
  for (std::size_t edge = 0; edge < m_Shares.size(); ++edge)
  {
    m_Shares[edge] = static_cast<double>(edge);
  }
  m_LowerShare = this->ShareBelow(m_Range.lower);
  m_UpperShare = this->ShareBelow(m_Range.upper);
}

double
HeatAxis::ShareBelow(double heat) const
{
  const double      coordinate = BinCoordinateOf(heat);
  const std::size_t bin = std::min(static_cast<std::size_t>(coordinate), m_Shares.size() - 2);
  return m_Shares[bin] + (coordinate - static_cast<double>(bin)) * (m_Shares[bin + 1] - m_Shares[bin]);
}

double
HeatAxis::PositionOf(double heat) const
{
  const double position = m_Scale == HeatScale::Normalized
                            ? (heat - m_Range.lower) / (m_Range.upper - m_Range.lower)
                            : (this->ShareBelow(heat) - m_LowerShare) / (m_UpperShare - m_LowerShare);
  return std::clamp(position, 0.0, 1.0);
}

double
HeatAxis::HeatAt(double position) const
{
  const double within = std::clamp(position, 0.0, 1.0);
  if (m_Scale == HeatScale::Normalized)
  {
    return m_Range.lower + within * (m_Range.upper - m_Range.lower);
  }
  const double share = m_LowerShare + within * (m_UpperShare - m_LowerShare);
  const auto   edge = std::lower_bound(m_Shares.begin(), m_Shares.end(), share);
  if (edge == m_Shares.begin())
  {
    return m_Range.lower;
  }
  const auto   bin = static_cast<double>(edge - m_Shares.begin() - 1);
  const double below = *(edge - 1);
  const double inside = edge == m_Shares.end() ? 1.0 : (share - below) / (*edge - below);
  return std::clamp(HeatOfBinCoordinate(bin + inside), m_Range.lower, m_Range.upper);
}

RGBColor
HeatAxis::ColorOf(double heat) const
{
  if (m_Scale == HeatScale::Normalized)
  {
    return HeatColor(this->PositionOf(heat));
  }
  const unsigned int bin = HeatHistogram::BinOf(static_cast<float>(heat));
  const double       share = 0.5 * (m_Shares[bin] + m_Shares[bin + 1]);
  return HeatColor((share - m_LowerShare) / (m_UpperShare - m_LowerShare));
}

HeatHistogram
BalanceClasses(const HeatHistogram & histogram, std::size_t row, const std::vector<HeatClass> & classes)
{
  constexpr double           weightOfClass = 1e6;
  HeatHistogram              balanced({ histogram.GetTimeSteps()[row] });
  std::vector<std::uint32_t> counts(HeatHistogram::NumberOfBins, 0);
  const auto                 binAt = [](double heat) {
    return heat >= 1.0 ? HeatHistogram::NumberOfBins : HeatHistogram::BinOf(static_cast<float>(heat));
  };
  for (const HeatClass & heatClass : classes)
  {
    const unsigned int          first = std::max(1U, binAt(heatClass.lowerHeat)); // bin 0 is not on the axis
    const unsigned int          end = binAt(heatClass.upperHeat);
    const std::uint32_t * const source = histogram.GetRow(row);
    double                      voxels = 0.0;
    for (unsigned int bin = first; bin < end; ++bin)
    {
      voxels += source[bin];
    }
    for (unsigned int bin = first; bin < end; ++bin)
    {
      counts[bin] = static_cast<std::uint32_t>(std::lround(voxels > 0.0 ? source[bin] * weightOfClass / voxels : 0.0));
    }
  }
  balanced.AddToRow(0, counts.data());
  return balanced;
}
} // namespace shapeton
