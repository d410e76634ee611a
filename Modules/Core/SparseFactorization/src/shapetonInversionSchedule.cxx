#include "shapetonInversionSchedule.h"

#include <algorithm>
#include <chrono>

namespace shapeton
{
InversionSchedule::InversionSchedule(const Supernodes &   supernodes,
                                     const FactorLayout & layout,
                                     const SubtreeTasks & tasks,
                                     int                  number,
                                     int                  atOnce,
                                     const MatrixOf &     matrixOf,
                                     const Take &         take,
                                     const Progress &     progress)
  : m_Supernodes(supernodes)
  , m_Layout(layout)
  , m_Tasks(tasks)
  , m_MatrixOf(matrixOf)
  , m_Take(take)
  , m_Number(number)
  , m_Progress(progress)
{
  for (int i = 0; i < std::min(atOnce, number); ++i)
  {
    this->Start();
  }
}

void
InversionSchedule::Start()
{
  if (m_Started < m_Number)
  {
    m_Flights.emplace_back();
    m_Flights.back().matrix = m_Started++;
    m_Flights.back().factor = std::move(m_SpareFactor);
  }
}

std::size_t
InversionSchedule::PiecesOf(Stage stage) const
{
  switch (stage)
  {
    case Stage::Begin:
    case Stage::Trunk:
      return 1;
    case Stage::Factor:
    case Stage::Invert:
      return m_Tasks.roots.size();
    default:
      return 0;
  }
}

/** Takes a task of the earliest matrix with available tasks. */
InversionSchedule::Flight *
InversionSchedule::FindWork()
{
  for (Flight & flight : m_Flights)
  {
    if (flight.next < this->PiecesOf(flight.stage))
    {
      return &flight;
    }
  }
  return nullptr;
}

void
InversionSchedule::Report()
{
  const std::size_t ofOne = this->PiecesOf(Stage::Begin) + this->PiecesOf(Stage::Factor) +
                            this->PiecesOf(Stage::Trunk) + this->PiecesOf(Stage::Invert);
  m_Progress(static_cast<double>(m_Done) / static_cast<double>(ofOne * m_Number));
}

/** Processes the trunk. This is the longest task, so it checks for interruption and reports progress. */
void
InversionSchedule::RunTrunk(FrontalInverse & inverse, FrontWorkspace & workspace)
{
  for (auto s = m_Tasks.trunk.begin(); s != m_Tasks.trunk.end() && !m_Stops; ++s)
  {
    inverse.Factor(*s, workspace);
    this->Report();
  }
  for (auto s = m_Tasks.trunk.rbegin(); s != m_Tasks.trunk.rend() && !m_Stops; ++s)
  {
    inverse.Invert(*s, workspace);
    inverse.GatherChildren(*s, workspace); // frees the front; the subtrees are now independent
    this->Report();
  }
}

void
InversionSchedule::RunPiece(Flight & flight, Stage stage, std::size_t piece, FrontWorkspace & workspace)
{
  if (stage == Stage::Begin)
  {
    if (!flight.factor)
    {
      flight.factor = AlignedBuffer(m_Layout.begin.back());
    }
    flight.inverse =
      std::make_unique<FrontalInverse>(m_Supernodes, m_Layout, m_MatrixOf(flight.matrix), std::move(flight.factor));
    return;
  }
  if (stage == Stage::Trunk)
  {
    this->RunTrunk(*flight.inverse, workspace);
    return;
  }
  const int root = m_Tasks.roots[piece];
  const int first = m_Supernodes.firstDescendant[root];
  if (stage == Stage::Factor)
  {
    for (int s = first; s <= root; ++s)
    {
      flight.inverse->Factor(s, workspace);
    }
    return;
  }
  for (int s = root; s >= first; --s)
  {
    flight.inverse->Invert(s, workspace);
  }
}

/** Called under the lock when a task is complete. The results of the first matrices in flight are passed on in
 * order. */
void
InversionSchedule::Advance(Flight & flight)
{
  --flight.running;
  while (flight.stage != Stage::End && flight.running == 0 && flight.next == this->PiecesOf(flight.stage))
  {
    flight.stage = static_cast<Stage>(static_cast<int>(flight.stage) + 1);
    flight.next = 0;
  }
  while (!m_Flights.empty() && m_Flights.front().stage == Stage::End)
  {
    m_Take(m_Flights.front().matrix, m_Flights.front().inverse->Elements());
    m_SpareFactor = m_Flights.front().inverse->TakeFactor();
    m_Flights.pop_front();
    this->Start();
  }
  m_Changed.notify_all();
}

/** Runs one task, or waits briefly for one. Called under the lock. */
void
InversionSchedule::Step(std::unique_lock<std::mutex> & lock, FrontWorkspace & workspace)
{
  Flight * const flight = this->FindWork();
  if (!flight)
  {
    // Another worker is running a task and will notify on completion.
    constexpr std::chrono::milliseconds untilReport(20);
    m_Changed.wait_for(lock, untilReport);
    lock.unlock();
    this->Report();
    lock.lock();
    return;
  }
  const Stage       stage = flight->stage;
  const std::size_t piece = flight->next++;
  ++flight->running;
  lock.unlock();
  this->RunPiece(*flight, stage, piece, workspace);
  ++m_Done;
  this->Report();
  lock.lock();
  if (!m_Stops)
  {
    this->Advance(*flight);
  }
}

void
InversionSchedule::Work()
{
  FrontWorkspace               workspace(m_Layout);
  std::unique_lock<std::mutex> lock(m_Mutex);
  try
  {
    while (!m_Stops && !m_Flights.empty())
    {
      this->Step(lock, workspace);
    }
  }
  catch (...)
  {
    if (!lock.owns_lock())
    {
      lock.lock();
    }
    m_Failure = m_Failure ? m_Failure : std::current_exception();
    m_Stops = true;
    m_Changed.notify_all();
  }
  if (m_Failure)
  {
    std::rethrow_exception(m_Failure);
  }
}
} // namespace shapeton
