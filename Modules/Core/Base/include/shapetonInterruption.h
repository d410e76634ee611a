#ifndef shapetonInterruption_h
#define shapetonInterruption_h

#include "BaseExport.h"

#include <atomic>
#include <exception>
#include <functional>
#include <thread>

namespace shapeton
{
/** \class Interruption
 * \brief Lets work be stopped between two reports of its progress.
 *
 * As long as it lives, reports, loops and long steps of the thread that made it ask `check` whether to go on, many
 * times a second at no certain moments. `check` may throw; the exception reaches the caller of the work, and threads
 * that work for it stop, too. Where one lives within another, both are asked.
 *
 * \code
 * const Interruption interruption([&] { if (stopButton) { throw itk::ProcessAborted(__FILE__, __LINE__); } });
 * \endcode
 *
 * \ingroup Base */
class Base_EXPORT Interruption
{
public:
  explicit Interruption(std::function<void()> check);
  ~Interruption();
  Interruption(const Interruption &) = delete;
  Interruption &
  operator=(const Interruption &) = delete;

  /** Throws where the work of this thread has to stop. Costs some nanoseconds. */
  static void
  Check();

  /** What the work of this thread asks; null for nothing. */
  static Interruption *
  OfThread();

  /** \class Inherited
   * \brief This thread, which works for another one, asks what that one does as long as this lives. \ingroup Base */
  class Base_EXPORT Inherited
  {
  public:
    explicit Inherited(Interruption * interruption);
    ~Inherited();
    Inherited(const Inherited &) = delete;
    Inherited &
    operator=(const Inherited &) = delete;

  private:
    Interruption * m_Before;
  };

private:
  void
  Ask();

  const std::function<void()> m_Check;
  const std::thread::id       m_Owner{ std::this_thread::get_id() };
  Interruption * const        m_Outer;
  std::exception_ptr          m_Exception; ///< written before m_HasStopped is
  std::atomic<bool>           m_HasStopped{ false };
};

/** \class RareInterruption
 * \brief Asks Interruption once in many calls, for steps that take less than a microsecond.
 *
 * \ingroup Base */
class RareInterruption
{
public:
  void
  Check()
  {
    constexpr unsigned int period = 1024;
    if (++m_Calls % period == 0)
    {
      Interruption::Check();
    }
  }

private:
  unsigned int m_Calls{ 0 };
};
} // namespace shapeton

#endif
