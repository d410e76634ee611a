#ifndef shapetonInterruption_h
#define shapetonInterruption_h

#include "ShapetonCommonExport.h"

#include <atomic>
#include <exception>
#include <functional>
#include <thread>

namespace shapeton
{
/** \class Interruption
 * \brief Allows work to be stopped between two progress reports.
 *
 * While it exists, progress reports, loops and long steps of the thread that constructed it call `check` many times a
 * second, at irregular times. `check` may throw; the exception propagates to the caller of the work, and its worker
 * threads stop, too. Interruptions can be nested; all of them are called.
 *
 * \code
 * const Interruption interruption([&] { if (stopButton) { throw itk::ProcessAborted(__FILE__, __LINE__); } });
 * \endcode
 *
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT Interruption
{
public:
  explicit Interruption(std::function<void()> check);
  ~Interruption();
  Interruption(const Interruption &) = delete;
  Interruption &
  operator=(const Interruption &) = delete;

  /** Throws if the work of this thread must stop. Takes a few nanoseconds. */
  static void
  Check();

  /** The active Interruption of this thread, or null. */
  static Interruption *
  OfThread();

  /** \class Inherited
   * \brief Makes a worker thread use the Interruption of its calling thread during the lifetime of this object.
   * \ingroup ShapetonCommon */
  class ShapetonCommon_EXPORT Inherited
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
  std::exception_ptr          m_Exception; ///< set before m_HasStopped
  std::atomic<bool>           m_HasStopped{ false };
};

/** \class RareInterruption
 * \brief Checks Interruption only once per many calls, for steps that take less than a microsecond.
 *
 * \ingroup ShapetonCommon */
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
