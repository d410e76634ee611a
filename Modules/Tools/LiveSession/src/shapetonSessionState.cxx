#include "shapetonSessionState.h"

namespace shapeton
{
namespace
{
/** Changes the view; a failure concerns only the view in which it occurred. */
void
Show(SessionState::View view, SessionState & state)
{
  state.hasFailed = state.hasFailed && state.view == view;
  state.view = view;
}
} // namespace

SessionState
After(SessionState state, SessionEvent event)
{
  using Event = SessionEvent;
  switch (event)
  {
    case Event::WalkChanged:
      state = { state.view, SessionState::Walk::Stale };
      break;
    case Event::HeatTimeChanged:
      state = { SessionState::View::Heat, state.walk };
      break;
    case Event::DensityShown:
    case Event::HeatShown:
      state.wish = SessionState::Wish::None; // the later command wins
      Show(event == Event::HeatShown ? SessionState::View::Heat : SessionState::View::Density, state);
      break;
    case Event::WalkMoved:
      state.hasFailed = false;
      break;
    case Event::ObjectsWanted:
      state.wish = state.wish == SessionState::Wish::None ? SessionState::Wish::Find : state.wish;
      state.hasFailed = false;
      break;
    case Event::ChoiceWanted:
      state.view = SessionState::View::Heat;
      state.wish = SessionState::Wish::ChooseAndFind;
      state.hasFailed = false;
      break;
    case Event::HeatReleased:
      state.heat = SessionState::Heat::None;
      state.wish = SessionState::Wish::None;
      break;
    case Event::WalkPlaced:
      state.walk = SessionState::Walk::Placed;
      break;
    case Event::WalkParked:
      state.walk = state.walk == SessionState::Walk::Placed ? SessionState::Walk::Parked : state.walk;
      break;
    case Event::ParametersChosen:
      state.wish = SessionState::Wish::Find;
      break;
    case Event::CoarseHeatComputed:
      state.heat = SessionState::Heat::Coarse;
      break;
    case Event::ExactHeatComputed:
      state.heat = SessionState::Heat::Exact;
      break;
    case Event::ObjectsFound:
      state.wish = SessionState::Wish::None;
      break;
    case Event::Failed:
      state.hasFailed = true;
      break;
    case Event::ObjectsFailed:
      state.wish = SessionState::Wish::None;
      state.hasFailed = true;
      break;
  }
  return state;
}

SessionWork
NextWork(const SessionState & state, bool isAtGoal)
{
  if (state.hasFailed)
  {
    return SessionWork::None;
  }
  if (state.view == SessionState::View::Density)
  {
    return state.walk != SessionState::Walk::Placed ? SessionWork::PlaceWalk
           : isAtGoal                               ? SessionWork::None
                                                    : SessionWork::MoveWalk;
  }
  if (state.wish == SessionState::Wish::ChooseAndFind)
  {
    return SessionWork::ChooseParameters;
  }
  switch (state.heat)
  {
    case SessionState::Heat::None:
      return SessionWork::ComputeCoarseHeat;
    case SessionState::Heat::Coarse:
      return SessionWork::ComputeExactHeat;
    default:
      return state.wish == SessionState::Wish::Find ? SessionWork::FindObjects : SessionWork::None;
  }
}
} // namespace shapeton
