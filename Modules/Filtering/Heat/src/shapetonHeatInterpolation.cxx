#include "shapetonHeatInterpolation.h"
#include "shapetonPi.h"

#include <vnl/algo/vnl_qr.h>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
// The mode that does not decay, x = 0, has this weight among the samples, which fixes the sum of the weights.
constexpr double weightOfTotal = 1000.0;

double
WeightOf(double rate)
{
  return rate == 1.0 ? weightOfTotal : 1.0;
}

/** rate^steps by squaring. */
double
Power(double rate, std::uint64_t steps)
{
  double result = 1.0;
  for (; steps > 0; steps /= 2, rate *= rate)
  {
    result *= steps % 2 == 1 ? rate : 1.0;
  }
  return result;
}

/** 1 - x for 16 values of x per octave, down to one that loses a thousandth of its heat, and 0. */
std::vector<double>
SampleRates(std::uint64_t last)
{
  constexpr double    sixteenthOfAnOctave = 0.95760328069857364694; // 2^(-1/16)
  std::vector<double> rates{ 1.0 };
  for (double x = 1.0; x * static_cast<double>(last) > 1e-3; x *= sixteenthOfAnOctave)
  {
    rates.push_back(1.0 - x);
  }
  return rates;
}
} // namespace

std::vector<std::uint64_t>
HeatInterpolation::ChooseNodes(std::uint64_t start, std::uint64_t end, std::size_t number)
{
  // Between equal distances in log(t) and Lobatto's; of ten mixtures, 0.7 had the least error at a ratio of 32.
  constexpr double           lobatto = 0.7;
  std::vector<std::uint64_t> nodes{ start };
  const double               octaves = std::log(static_cast<double>(end) / static_cast<double>(start));
  for (std::size_t k = 1; k < number && nodes.back() < end; ++k)
  {
    const double share = static_cast<double>(k) / static_cast<double>(number - 1);
    const double position = lobatto * 0.5 * (1.0 - std::cos(Pi * share)) + (1.0 - lobatto) * share;
    const auto   node = static_cast<std::uint64_t>(std::llround(start * std::exp(position * octaves)));
    nodes.push_back(k + 1 == number ? end : std::clamp(node, nodes.back() + 1, end));
  }
  return nodes;
}

HeatInterpolation::HeatInterpolation(const std::vector<std::uint64_t> & nodes)
  : m_Nodes(nodes), m_Rates(SampleRates(nodes.back()))
{
  const auto         rows = static_cast<unsigned int>(m_Rates.size());
  vnl_matrix<double> matrix(rows, static_cast<unsigned int>(nodes.size()));
  for (unsigned int row = 0; row < matrix.rows(); ++row)
  {
    for (unsigned int k = 0; k < matrix.cols(); ++k)
    {
      matrix(row, k) = WeightOf(m_Rates[row]) * Power(m_Rates[row], nodes[k]);
    }
  }
  m_Solver = std::make_unique<const vnl_qr<double>>(matrix);
}

HeatInterpolation::~HeatInterpolation() = default;

std::vector<double>
HeatInterpolation::WeightsAt(std::uint64_t step) const
{
  std::vector<double> weights(m_Nodes.size(), 0.0);
  const auto          hit = std::find(m_Nodes.begin(), m_Nodes.end(), step);
  if (hit != m_Nodes.end())
  {
    weights[hit - m_Nodes.begin()] = 1.0;
    return weights;
  }
  vnl_vector<double> wanted(static_cast<unsigned int>(m_Rates.size()));
  for (unsigned int row = 0; row < wanted.size(); ++row)
  {
    wanted[row] = WeightOf(m_Rates[row]) * Power(m_Rates[row], step);
  }
  const vnl_vector<double> solution = m_Solver->solve(wanted);
  std::copy(solution.begin(), solution.end(), weights.begin());
  return weights;
}
} // namespace shapeton
