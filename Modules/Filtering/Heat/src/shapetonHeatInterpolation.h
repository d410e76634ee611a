#ifndef shapetonHeatInterpolation_h
#define shapetonHeatInterpolation_h

#include <cstdint>
#include <memory>
#include <vector>

template <class T>
class vnl_qr;

namespace shapeton
{
/** \class HeatInterpolation
 * \brief The heat after any step of an interval as a sum of the heats at its nodes.
 *
 * After t steps the heat is a sum of modes, each times (1 - x)^t with x in [0, 1]. The weights minimize the squared
 * error of these functions over samples of x, and equal 1 in total. With 13 nodes and an end / start ratio of 32 the
 * error is below 2e-6 for every x, a fifth of that of polynomials in log(t). Only products, sums and quotients are
 * computed, so the weights are the same on every CPU. */
class HeatInterpolation
{
public:
  /** `number` steps that are the nodes of an interval, from `start` to `end`, ascending; fewer in short intervals. */
  static std::vector<std::uint64_t>
  ChooseNodes(std::uint64_t start, std::uint64_t end, std::size_t number);

  explicit HeatInterpolation(const std::vector<std::uint64_t> & nodes);
  ~HeatInterpolation();

  /** The weight of each node; 1 for the node at `step`, if there is one. */
  std::vector<double>
  WeightsAt(std::uint64_t step) const;

private:
  std::vector<std::uint64_t>            m_Nodes;
  std::vector<double>                   m_Rates; // the samples of 1 - x
  std::unique_ptr<const vnl_qr<double>> m_Solver;
};
} // namespace shapeton

#endif
