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
  /** Each voxel counts `weight` times. Called concurrently; `worker` identifies the thread and is less than the number
   * of ITK's threads. */
  virtual void
  CountRow(std::size_t /*snapshot*/, const float * /*heat*/, std::uint32_t /*weight*/, unsigned int /*worker*/)
  {}
  virtual void
  AddCounts(std::size_t /*snapshot*/, const std::uint32_t * /*counts*/, std::uint32_t /*weight*/)
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
