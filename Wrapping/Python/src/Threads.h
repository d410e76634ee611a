#ifndef Threads_h
#define Threads_h

#include "shapetonInterruption.h"

#include <pybind11/pybind11.h>

#include <memory>

/** Release of the GIL in functions of the library, and their interruption by signals and interpreter shutdown. */
namespace shapeton::python
{
namespace py = pybind11;

/** \class WithGil
 * \brief Holds the GIL in a block.
 *
 * During interpreter shutdown only the finalizing thread gets the lock. Any other thread that requests it blocks
 * forever, as in Python 3.14. Older versions unwind such a thread, which makes C++ libraries abort the process.
 * Destructors of objects owned by Python must not use this class: see Share(). */
class WithGil
{
public:
  WithGil();
  ~WithGil();
  WithGil(const WithGil &) = delete;
  WithGil &
  operator=(const WithGil &) = delete;

private:
  PyGILState_STATE m_State;
};

/** Shares a Python object with C++ code, which may release it in any thread and at any time. Objects that hold such a
 * reference may live until the process ends, for example as a module global. The reference is therefore released only
 * while the interpreter is alive. After shutdown it is leaked, because most threads would block on the GIL; the memory
 * is freed when the process exits. */
std::shared_ptr<PyObject>
Share(py::object object);

/** \class WithoutGil
 * \brief Lets other Python threads run during a function of the library, and lets signals stop it.
 *
 * At interpreter shutdown, functions in other threads stop with SystemExit and are awaited: their ITK threads must not
 * outlive ITK. */
class WithoutGil
{
public:
  WithoutGil();

private:
  /** Counts the running functions. */
  class Call
  {
  public:
    Call();
    ~Call();
    Call(const Call &) = delete;
    Call &
    operator=(const Call &) = delete;
  };

  class Released
  {
  public:
    Released();
    ~Released();
    Released(const Released &) = delete;
    Released &
    operator=(const Released &) = delete;

  private:
    PyThreadState * m_State;
  };

  const Call         m_Call;
  const Released     m_Released;
  const Interruption m_Interruption;
};
using ReleaseGil = py::call_guard<WithoutGil>;

/** Registers the thread functions and the shutdown handler. */
void
AddThreads(py::module_ & module);
} // namespace shapeton::python

#endif
