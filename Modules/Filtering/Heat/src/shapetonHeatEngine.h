#ifndef shapetonHeatEngine_h
#define shapetonHeatEngine_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class HeatEngine
 * \brief Fields of a HeatDiffusionSolver run and operations on them, with identical results on the CPU and on a GPU.
 *
 * Fields are identified by numbers and initially uninitialized. The GPU plug-in implements its own engine, so this
 * header does not include library code. */
class HeatEngine
{
public:
  using Field = unsigned int;
  static constexpr Field Heat = 0;
  static constexpr Field Even = 1; ///< T_k of even k; the next step of explicit steps
  static constexpr Field Odd = 2;  ///< for steps of the recurrence; the rest of compensated sums
  static constexpr Field Difference = 3;
  static constexpr Field FirstNode = 4;
  /** Largest number of fields that the solver requests: the number of interpolation nodes. */
  static constexpr std::size_t MostNodes = 13;
  static constexpr std::size_t MostFields = FirstNode + MostNodes;

  using Expansions = std::vector<std::vector<double>>; ///< coefficients of each node of an interval

  /** Every n-th slice: all that the nodes of counted snapshots hold in large volumes. An engine may compute the others.
   */
  using SliceStride = std::size_t;

  HeatEngine() = default;
  HeatEngine(const HeatEngine &) = delete;
  HeatEngine &
  operator=(const HeatEngine &) = delete;
  virtual ~HeatEngine() = default;

  /** Largest number of steps per call; even. */
  virtual unsigned int
  GetLongestStretch(bool chebyshev) const = 0;

  virtual void
  Copy(Field from, Field to) = 0;
  virtual void
  Exchange(Field a, Field b) = 0;
  virtual void
  Clear(Field field) = 0;
  /** to = factor * from. */
  virtual void
  Scale(Field from, Field to, float factor, SliceStride stride) = 0;
  virtual void
  ClampToZero(Field field, SliceStride stride) = 0;

  /** Explicit steps of the heat; overwrites Even. With `compensated`, Odd accumulates the rounding errors. */
  virtual void
  StepExplicitly(unsigned int steps, float dt, bool compensated) = 0;

  /** Steps done + 1 .. done + steps (`done` and `steps` even) of the recurrence from T_done in Even and its difference.
   * Afterwards the last T_k is in Even, Odd is overwritten, and sum_k coefficients[g][k] T_k is added to the nodes, in
   * pairs of terms; `stride` applies to all nodes but the last. The first step of the recurrence uses half of `scale`.
   */
  virtual void
  StepChebyshev(std::size_t        done,
                unsigned int       steps,
                float              scale,
                const Expansions & coefficients,
                SliceStride        stride) = 0;

  /** The number of voxels that have changed by more than `change` times their heat, or times `least` if they are
   * colder. */
  virtual std::uint64_t
  CountMoved(Field before, Field after, float change, float least) = 0;

  /** Passes the field to the snapshots as the heat of a snapshot. */
  virtual void
  Show(std::size_t snapshot, Field field) = 0;

  using Weights = std::array<float, MostNodes>;
  /** Passes max(0, sum_k weights[i][k] * nodes[k]) to the snapshots as the heat of snapshot first + i. With a stride,
   * a counted slice stands for itself and the slices up to the next. */
  virtual void
  ShowCombined(std::size_t                          first,
               const std::array<Field, MostNodes> & nodes,
               const std::vector<Weights> &         weights,
               SliceStride                          stride) = 0;

  /** Writes the heat back to the input field. */
  virtual void
  Finish() = 0;
};

/** The coefficients added by a step of the recurrence, for the terms k and k - 1, k even. */
struct ChebyshevPair
{
  float even;
  float odd;
};

/** False beyond the end of the expansion. */
inline bool
FindPair(const std::vector<double> & coefficients, std::size_t k, ChebyshevPair & pair)
{
  pair.even = k < coefficients.size() ? static_cast<float>(coefficients[k]) : 0.0F;
  pair.odd = k - 1 < coefficients.size() ? static_cast<float>(coefficients[k - 1]) : 0.0F;
  return k - 1 < coefficients.size();
}
} // namespace shapeton

#endif
