#include "shapetonInversionSchedule.h"

#include <algorithm>

namespace shapeton
{
InversionSchedule::InversionSchedule(const Supernodes &   supernodes,
                                     const FactorLayout & layout,
                                     const SubtreeTasks & tasks,
                                     int                  number,
                                     int                  atOnce,
                                     const MatrixOf &     matrixOf,
                                     const Take &         take)
  : m_Supernodes(supernodes), m_Layout(layout), m_Tasks(tasks), m_MatrixOf(matrixOf), m_Take(take), m_Number(number)
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

/** A piece of the earliest matrix that has one to be taken. */
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
InversionSchedule::RunTrunk(FrontalInverse & inverse, FrontWorkspace & workspace)
{
  for (const int s : m_Tasks.trunk)
  {
    inverse.Factor(s, workspace);
  }
  for (auto s = m_Tasks.trunk.rbegin(); s != m_Tasks.trunk.rend(); ++s)
  {
    inverse.Invert(*s, workspace);
    inverse.GatherChildren(*s, workspace); // frees the front, and subtrees can be worked on alone
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

/** Called under the lock when a piece is done. The results of the first matrices in flight are handed on in order. */
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

void
InversionSchedule::Work()
{
  FrontWorkspace               workspace(m_Layout);
  std::unique_lock<std::mutex> lock(m_Mutex);
  while (!m_Failure && !m_Flights.empty())
  {
    Flight * const flight = this->FindWork();
    if (!flight)
    {
      m_Changed.wait(lock); // some other worker is at a piece, and will say so when it is done
      continue;
    }
    const Stage       stage = flight->stage;
    const std::size_t piece = flight->next++;
    ++flight->running;
    lock.unlock();
    try
    {
      this->RunPiece(*flight, stage, piece, workspace);
      lock.lock();
      this->Advance(*flight);
    }
    catch (...)
    {
      if (!lock.owns_lock())
      {
        lock.lock();
      }
      m_Failure = m_Failure ? m_Failure : std::current_exception();
      m_Changed.notify_all();
    }
  }
  if (m_Failure)
  {
    std::rethrow_exception(m_Failure);
  }
}
} // namespace shapeton
