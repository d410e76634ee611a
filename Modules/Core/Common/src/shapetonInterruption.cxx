#include "shapetonInterruption.h"

#include <utility>

namespace shapeton
{
namespace
{
thread_local Interruption * ofThread = nullptr;
}

Interruption::Interruption(std::function<void()> check) : m_Check(std::move(check)), m_Outer(ofThread)
{
  ofThread = this;
}

Interruption::~Interruption() { ofThread = m_Outer; }

Interruption *
Interruption::OfThread()
{
  return ofThread;
}

void
Interruption::Check()
{
  if (ofThread)
  {
    ofThread->Ask();
  }
}

void
Interruption::Ask()
{
  if (m_Outer)
  {
    m_Outer->Ask();
  }
  if (m_HasStopped)
  {
    std::rethrow_exception(m_Exception);
  }
  if (std::this_thread::get_id() != m_Owner)
  {
    return;
  }
  try
  {
    m_Check();
  }
  catch (...)
  {
    m_Exception = std::current_exception();
    m_HasStopped = true;
    throw;
  }
}

Interruption::Inherited::Inherited(Interruption * interruption) : m_Before(ofThread) { ofThread = interruption; }

Interruption::Inherited::~Inherited() { ofThread = m_Before; }
} // namespace shapeton
