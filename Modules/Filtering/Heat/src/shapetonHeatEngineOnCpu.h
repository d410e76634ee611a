#ifndef shapetonHeatEngineOnCpu_h
#define shapetonHeatEngineOnCpu_h

#include "shapetonHeatDiffusionSolver.h"
#include "shapetonHeatEngine.h"

#include <deque>
#include <functional>

namespace shapeton
{
/** \class HeatEngineOnCpu
 * \brief CPU heat engine with time tiles of rows, vectorized along x. */
class HeatEngineOnCpu : public HeatEngine
{
public:
  /** Works in `heat` and writes it back in Finish(). Fields are allocated on first use. Each allocation is reported to
   * `allocated` because it takes time for large volumes. */
  HeatEngineOnCpu(const VolumeGradientOperator & volumeGradient,
                  PaddedField &                  heat,
                  HeatSnapshots &                snapshots,
                  std::function<void()>          allocated);

  unsigned int
  GetLongestStretch(bool chebyshev) const override;
  void
  Copy(Field from, Field to) override;
  void
  Exchange(Field a, Field b) override;
  void
  Clear(Field field) override;
  void
  Scale(Field from, Field to, float factor, SliceStride stride) override;
  void
  ClampToZero(Field field, SliceStride stride) override;
  void
  StepExplicitly(unsigned int steps, float dt, bool compensated) override;
  void
  StepChebyshev(std::size_t done, unsigned int steps, float scale, const Expansions & coefficients, SliceStride stride)
    override;
  std::uint64_t
  CountMoved(Field before, Field after, float change, float least) override;
  void
  Show(std::size_t snapshot, Field field) override;
  void
  ShowCombined(std::size_t                          first,
               const std::array<Field, MostNodes> & nodes,
               const std::vector<Weights> &         weights,
               SliceStride                          stride) override;
  void
  Finish() override;

protected:
  /** Returns a field, allocating it on first use; with a stride, every n-th slice needs memory. */
  float *
  Get(Field field, SliceStride stride = 1);

  const VolumeGradientOperator & m_VolumeGradient;
  const PaddedGrid &             m_Grid;

private:
  void
  ShowRow(std::size_t snapshot, std::size_t row, const float * heat, std::uint32_t weight, unsigned int worker);

  PaddedField &           m_Heat;
  HeatSnapshots &         m_Snapshots;
  std::function<void()>   m_Allocated;
  std::deque<PaddedField> m_Fields;
};
} // namespace shapeton

#endif
