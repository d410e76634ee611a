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

const std::vector<Transition> transitions{
  // A walk
  { {}, Event::WalkPlaced, { View::Density, Walk::Placed }, Work::MoveWalk },
  { { View::Density, Walk::Placed }, Event::WalkChanged, {}, Work::PlaceWalk },
  { { View::Density, Walk::Placed }, Event::WalkParked, { View::Density, Walk::Parked }, Work::PlaceWalk },
  { {}, Event::WalkParked, {}, Work::PlaceWalk },
  { { View::Density, Walk::Parked }, Event::WalkPlaced, { View::Density, Walk::Placed }, Work::MoveWalk },
  { {}, Event::Failed, { View::Density, Walk::Stale, Heat::None, Wish::None, failed }, Work::None },
  { { View::Density, Walk::Stale, Heat::None, Wish::None, failed }, Event::WalkChanged, {}, Work::PlaceWalk },
  { { View::Density, Walk::Placed, Heat::None, Wish::None, failed },
    Event::WalkMoved,
    { View::Density, Walk::Placed },
    Work::MoveWalk },
  // Heat of the same walk
  { { View::Density, Walk::Placed }, Event::HeatTimeChanged, { View::Heat, Walk::Placed }, Work::ComputeCoarseHeat },
  { { View::Heat, Walk::Placed },
    Event::CoarseHeatComputed,
    { View::Heat, Walk::Placed, Heat::Coarse },
    Work::ComputeExactHeat },
  { { View::Heat, Walk::Placed, Heat::Coarse },
    Event::WalkParked,
    { View::Heat, Walk::Parked, Heat::Coarse },
    Work::ComputeExactHeat },
  { { View::Heat, Walk::Parked, Heat::Coarse },
    Event::ExactHeatComputed,
    { View::Heat, Walk::Parked, Heat::Exact },
    Work::None },
  { { View::Heat, Walk::Parked, Heat::Exact },
    Event::HeatTimeChanged,
    { View::Heat, Walk::Parked },
    Work::ComputeCoarseHeat },
  { { View::Heat, Walk::Parked, Heat::Exact },
    Event::DensityShown,
    { View::Density, Walk::Parked, Heat::Exact },
    Work::PlaceWalk },
  { { View::Density, Walk::Placed, Heat::Exact },
    Event::HeatShown,
    { View::Heat, Walk::Placed, Heat::Exact },
    Work::None },
  { { View::Density, Walk::Stale, Heat::Exact }, Event::HeatReleased, {}, Work::PlaceWalk },
  { { View::Heat, Walk::Parked, Heat::Exact }, Event::WalkChanged, { View::Heat }, Work::ComputeCoarseHeat },
  // Objects of this heat
  { { View::Heat, Walk::Parked, Heat::Exact },
    Event::ObjectsWanted,
    { View::Heat, Walk::Parked, Heat::Exact, Wish::Find },
    Work::FindObjects },
  { { View::Heat, Walk::Placed, Heat::Coarse },
    Event::ObjectsWanted,
    { View::Heat, Walk::Placed, Heat::Coarse, Wish::Find },
    Work::ComputeExactHeat },
  { { View::Heat, Walk::Parked, Heat::Exact, Wish::Find },
    Event::ObjectsFound,
    { View::Heat, Walk::Parked, Heat::Exact },
    Work::None },
  { { View::Heat, Walk::Parked, Heat::Exact, Wish::Find },
    Event::ObjectsFailed,
    { View::Heat, Walk::Parked, Heat::Exact, Wish::None, failed },
    Work::None },
  // Objects of chosen parameters: the choice starts again and still wants its objects
  { { View::Density, Walk::Placed },
    Event::ChoiceWanted,
    { View::Heat, Walk::Placed, Heat::None, Wish::ChooseAndFind },
    Work::ChooseParameters },
  { { View::Heat, Walk::Placed, Heat::None, Wish::ChooseAndFind },
    Event::ObjectsWanted,
    { View::Heat, Walk::Placed, Heat::None, Wish::ChooseAndFind },
    Work::ChooseParameters },
  { { View::Heat, Walk::Parked, Heat::Exact, Wish::ChooseAndFind },
    Event::ParametersChosen,
    { View::Heat, Walk::Stale, Heat::None, Wish::Find },
    Work::ComputeCoarseHeat },
  // A later command wins
  { { View::Heat, Walk::Parked, Heat::Exact, Wish::ChooseAndFind },
    Event::WalkChanged,
    { View::Heat },
    Work::ComputeCoarseHeat },
  { { View::Heat, Walk::Parked, Heat::Exact, Wish::ChooseAndFind },
    Event::DensityShown,
    { View::Density, Walk::Parked, Heat::Exact },
    Work::PlaceWalk },
  { { View::Heat, Walk::Parked, Heat::Exact, Wish::Find },
    Event::HeatShown,
    { View::Heat, Walk::Parked, Heat::Exact },
    Work::None },
  { { View::Heat, Walk::Parked, Heat::Exact, Wish::Find },
    Event::HeatTimeChanged,
    { View::Heat, Walk::Parked },
    Work::ComputeCoarseHeat },
  // An error belongs to what is shown
  { { View::Heat, Walk::Placed, Heat::Exact, Wish::None, failed },
    Event::HeatShown,
    { View::Heat, Walk::Placed, Heat::Exact, Wish::None, failed },
    Work::None },
  { { View::Heat, Walk::Placed, Heat::Exact, Wish::None, failed },
    Event::DensityShown,
    { View::Density, Walk::Placed, Heat::Exact },
    Work::MoveWalk },
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
  EXPECT_EQ(NextWork({ View::Density, Walk::Placed }, true), Work::None);
  EXPECT_EQ(NextWork({ View::Density, Walk::Parked }, true), Work::PlaceWalk); // to be shown
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
