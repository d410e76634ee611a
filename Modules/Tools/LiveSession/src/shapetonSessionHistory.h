#ifndef shapetonSessionHistory_h
#define shapetonSessionHistory_h

#include "shapetonParticleDiffusionOptions.h"
#include "shapetonSessionState.h"
#include "shapetonStartRegion.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** The values of a session that Undo restores. */
struct SessionValues
{
  ParticleDiffusionOptions options;
  std::uint64_t            heatSteps{ 0 };
  SessionState::View       view{ SessionState::View::Density };
  StartMask::Pointer       barrier; ///< voxels that heat flows around; null for none
  std::uint64_t            barrierVoxels{ 0 };
};

/** The options, the time and the barrier that differ, as "p 4 -> 12, time of heat 60 -> 3000 steps"; empty if none do.
 */
std::string
ChangesBetween(const SessionValues & before, const SessionValues & after);

/** \class SessionHistory
 * \brief Earlier values, for Undo, and those that were undone, for Redo. */
class SessionHistory
{
public:
  /** Keeps the values before a change. Consecutive changes of one kind, such as those by a slider, are undone together,
   * unless the kind is empty. */
  void
  Add(const SessionValues & before, const std::string & kind);

  /** The values before the last change, or after the last one that was undone. Throw ParameterError if there are none.
   * \param now the current values */
  ///@{
  SessionValues
  Undo(const SessionValues & now);
  SessionValues
  Redo(const SessionValues & now);
  ///@}

  std::size_t
  NumberToUndo() const
  {
    return m_Before.size();
  }

  std::size_t
  NumberToRedo() const
  {
    return m_After.size();
  }

private:
  SessionValues
  Swap(const SessionValues & now, std::vector<SessionValues> & from, std::vector<SessionValues> & to);

  std::vector<SessionValues> m_Before;
  std::vector<SessionValues> m_After;
  std::string                m_Kind; ///< of the last change
};
} // namespace shapeton

#endif
