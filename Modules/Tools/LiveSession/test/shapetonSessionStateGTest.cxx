#include "shapetonSessionState.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>
#include <vector>

using namespace shapeton;
using View = SessionState::View;
using Walk = SessionState::Walk;
using Heat = SessionState::Heat;
using Wish = SessionState::Wish;
using Event = SessionEvent;
using Work = SessionWork;

namespace
{
constexpr bool failed = true;

auto
Tied(const SessionState & state)
{
  return std::make_tuple(state.view, state.walk, state.heat, state.wish, state.hasFailed);
}

struct Transition
{
  SessionState from;
  Event        event;
  SessionState to;
  Work         work; ///< the next one, before the goal is reached
};

// States that occur several times
const SessionState parked{ View::Density, Walk::Parked };
const SessionState placed{ View::Density, Walk::Placed };
const SessionState heatOfParked{ View::Heat, Walk::Parked };
const SessionState heatOfPlaced{ View::Heat, Walk::Placed };
const SessionState coarse{ View::Heat, Walk::Placed, Heat::Coarse };
const SessionState exact{ View::Heat, Walk::Parked, Heat::Exact };
const SessionState failedLater{ View::Heat, Walk::Placed, Heat::Exact, Wish::None, failed };
const SessionState failedAtOnce{ View::Density, Walk::Stale, Heat::None, Wish::None, failed };
const SessionState choosingAgain{ View::Heat, Walk::Parked, Heat::Exact, Wish::ChooseAndFind };
const SessionState choosing{ View::Heat, Walk::Placed, Heat::None, Wish::ChooseAndFind };
const SessionState finding{ View::Heat, Walk::Parked, Heat::Exact, Wish::Find };

const std::vector<Transition> transitions{
  // A walk
  { {}, Event::WalkPlaced, placed, Work::MoveWalk },
  { placed, Event::WalkChanged, {}, Work::PlaceWalk },
  { placed, Event::WalkParked, parked, Work::PlaceWalk },
  { {}, Event::WalkParked, {}, Work::PlaceWalk },
  { parked, Event::WalkPlaced, placed, Work::MoveWalk },
  { {}, Event::Failed, failedAtOnce, Work::None },
  { failedAtOnce, Event::WalkChanged, {}, Work::PlaceWalk },
  { { View::Density, Walk::Placed, Heat::None, Wish::None, failed }, Event::WalkMoved, placed, Work::MoveWalk },
  // Heat of the same walk
  { placed, Event::HeatTimeChanged, heatOfPlaced, Work::ComputeCoarseHeat },
  { heatOfPlaced, Event::CoarseHeatComputed, coarse, Work::ComputeExactHeat },
  { coarse, Event::WalkParked, { View::Heat, Walk::Parked, Heat::Coarse }, Work::ComputeExactHeat },
  { { View::Heat, Walk::Parked, Heat::Coarse }, Event::ExactHeatComputed, exact, Work::None },
  { exact, Event::HeatTimeChanged, heatOfParked, Work::ComputeCoarseHeat },
  { exact, Event::DensityShown, { View::Density, Walk::Parked, Heat::Exact }, Work::PlaceWalk },
  { { View::Density, Walk::Placed, Heat::Exact },
    Event::HeatShown,
    { View::Heat, Walk::Placed, Heat::Exact },
    Work::None },
  { { View::Density, Walk::Stale, Heat::Exact }, Event::HeatReleased, {}, Work::PlaceWalk },
  { exact, Event::WalkChanged, { View::Heat }, Work::ComputeCoarseHeat },
  // Objects of this heat
  { exact, Event::ObjectsWanted, finding, Work::FindObjects },
  { coarse, Event::ObjectsWanted, { View::Heat, Walk::Placed, Heat::Coarse, Wish::Find }, Work::ComputeExactHeat },
  { finding, Event::ObjectsFound, exact, Work::None },
  { finding, Event::ObjectsFailed, { View::Heat, Walk::Parked, Heat::Exact, Wish::None, failed }, Work::None },
  // Objects with chosen parameters
  { placed, Event::ChoiceWanted, choosing, Work::ChooseParameters },
  { choosing, Event::ObjectsWanted, choosing, Work::ChooseParameters },
  { choosing, Event::ParametersChosen, { View::Heat, Walk::Placed, Heat::None, Wish::Find }, Work::ComputeCoarseHeat },
  { choosingAgain, Event::ParametersChosen, finding, Work::FindObjects }, // the same parameters as before
  // A later command wins
  { choosingAgain, Event::WalkChanged, { View::Heat }, Work::ComputeCoarseHeat },
  { choosingAgain, Event::DensityShown, { View::Density, Walk::Parked, Heat::Exact }, Work::PlaceWalk },
  { finding, Event::HeatShown, exact, Work::None },
  { finding, Event::HeatTimeChanged, heatOfParked, Work::ComputeCoarseHeat },
  // A failure concerns only the view in which it occurred
  { failedLater, Event::HeatShown, failedLater, Work::None },
  { failedLater, Event::DensityShown, { View::Density, Walk::Placed, Heat::Exact }, Work::MoveWalk },
};

/** The event of a completed piece of work. */
const std::map<Work, Event> completions{ { Work::PlaceWalk, Event::WalkPlaced },
                                         { Work::ChooseParameters, Event::ParametersChosen },
                                         { Work::ComputeCoarseHeat, Event::CoarseHeatComputed },
                                         { Work::ComputeExactHeat, Event::ExactHeatComputed },
                                         { Work::FindObjects, Event::ObjectsFound } };
} // namespace

TEST(SessionState, FollowsTheTableOfTransitions)
{
  for (const Transition & transition : transitions)
  {
    const auto row = &transition - transitions.data();
    const auto to = After(transition.from, transition.event);
    EXPECT_EQ(Tied(to), Tied(transition.to)) << "row " << row;
    EXPECT_EQ(NextWork(to, false), transition.work) << "row " << row;
  }
}

TEST(SessionState, AWalkAtItsGoalRests)
{
  EXPECT_EQ(NextWork(placed, true), Work::None);
  EXPECT_EQ(NextWork(parked, true), Work::PlaceWalk); // to be shown
}

TEST(SessionState, EveryStateThatCommandsReachComesToRest)
{
  using Key = decltype(Tied(SessionState()));
  constexpr auto              last = Event::ObjectsFailed;
  std::map<Key, SessionState> reached;
  std::vector<SessionState>   open{ {} };
  while (!open.empty())
  {
    const SessionState state = open.back();
    open.pop_back();
    if (!reached.emplace(Tied(state), state).second)
    {
      continue;
    }
    for (int event = 0; event <= static_cast<int>(Event::ChoiceWanted); ++event)
    {
      if (static_cast<Event>(event) != Event::ObjectsWanted || state.view == View::Heat) // as LiveSession requires
      {
        open.push_back(After(state, static_cast<Event>(event)));
      }
    }
    const auto completion = completions.find(NextWork(state, true));
    if (completion != completions.end())
    {
      open.push_back(After(state, completion->second));
      open.push_back(After(state, Event::WalkParked));
      open.push_back(After(state, Event::Failed));
      open.push_back(After(state, last));
    }
  }
  EXPECT_GT(reached.size(), 20U);
  for (const auto & [key, state] : reached)
  {
    EXPECT_TRUE(state.view == View::Heat || state.wish == Wish::None); // objects are those of the shown heat
    SessionState next = state;
    int          pieces = 0;
    for (Work work; (work = NextWork(next, true)) != Work::None && pieces < 10; ++pieces)
    {
      next = After(next, completions.at(work));
    }
    EXPECT_LE(pieces, 4); // parameters, coarse heat, exact heat, objects
  }
}
