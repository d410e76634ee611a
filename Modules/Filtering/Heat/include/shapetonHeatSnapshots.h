#ifndef shapetonHeatSnapshots_h
#define shapetonHeatSnapshots_h

#include <cstddef>
#include <cstdint>

namespace shapeton
{
/** \class HeatSnapshots
 * \brief Receives the heat from HeatDiffusionSolver after each requested step.
 * \ingroup ShapetonHeat */
class HeatSnapshots
{
public:
  virtual ~HeatSnapshots() = default;

  /** Whether HeatHistogram counts the heat of a snapshot: row by row on the CPU, all at once on a GPU. */
  virtual bool
  IsCounted(std::size_t) const
  {
    return false;
  }
  /** Called concurrently; `worker` identifies the thread and is less than the number of ITK's threads. */
  virtual void
  CountRow(std::size_t, const float *, unsigned int)
  {}
  virtual void
  AddCounts(std::size_t, const std::uint32_t *)
  {}

  /** Whether ShowRow() is called for a snapshot. */
  virtual bool
  IsShown(std::size_t) const
  {
    return true;
  }
  /** Row `row` = y + ny * z of the heat; threads as in CountRow(). */
  virtual void
  ShowRow(std::size_t snapshot, std::size_t row, const float * heat, unsigned int worker) = 0;
};
} // namespace shapeton

#endif
