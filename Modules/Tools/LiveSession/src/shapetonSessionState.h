#ifndef shapetonSessionState_h
#define shapetonSessionState_h

#include "ShapetonLiveSessionExport.h"

namespace shapeton
{
/** \class SessionState
 * \brief What a session shows, what it has computed, and what was requested.
 *
 * Commands and completed work are events; After() is the only place that changes the state, NextWork() the only one
 * that decides what to do. The data (visits, heat, objects) belong to LiveSession. */
struct SessionState
{
  enum class View
  {
    Density,
    Heat
  };
  enum class Walk
  {
    Stale,  ///< must start again
    Parked, ///< its memory is released
    Placed
  };
  enum class Heat
  {
    None,
    Coarse,
    Exact
  };
  /** Whether objects are to be found. */
  enum class Wish
  {
    None,
    Find,
    ChooseAndFind ///< with parameters by which objects separate
  };

  View view{ View::Density };
  Walk walk{ Walk::Stale };
  Heat heat{ Heat::None };
  Wish wish{ Wish::None };
  bool hasFailed{ false }; ///< no work until the next command that can change the outcome
};

enum class SessionEvent
{
  // Commands
  WalkChanged,     ///< an option or the start region
  HeatTimeChanged, ///< also shows the heat
  DensityShown,
  HeatShown,
  WalkMoved, ///< pause, resume or step
  ObjectsWanted,
  ChoiceWanted,
  // Completed work
  HeatReleased,
  WalkPlaced, ///< at its start, or where it was parked
  WalkParked,
  ParametersChosen,
  CoarseHeatComputed,
  ExactHeatComputed,
  ObjectsFound,
  Failed,
  ObjectsFailed ///< no objects were found
};

/** The next piece of work. */
enum class SessionWork
{
  None,
  PlaceWalk,
  MoveWalk,
  ChooseParameters,
  ComputeCoarseHeat,
  ComputeExactHeat,
  FindObjects
};

ShapetonLiveSession_EXPORT SessionState
After(SessionState state, SessionEvent event);

/** \param isAtGoal whether the walk has made all requested steps */
ShapetonLiveSession_EXPORT SessionWork
NextWork(const SessionState & state, bool isAtGoal);
} // namespace shapeton

#endif
