#ifndef Timer_h
#define Timer_h

#include <chrono>

namespace shapeton::python
{
/** \class Timer
 * \brief Periodic timer. */
class Timer
{
  using Clock = std::chrono::steady_clock;

public:
  explicit Timer(Clock::duration period) : m_Period(period) {}

  bool
  IsOver()
  {
    const auto now = Clock::now();
    const bool isOver = now >= m_Next;
    m_Next = isOver ? now + m_Period : m_Next;
    return isOver;
  }

private:
  Clock::duration   m_Period;
  Clock::time_point m_Next{};
};
} // namespace shapeton::python

#endif
