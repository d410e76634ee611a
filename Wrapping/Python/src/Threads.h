#ifndef Threads_h
#define Threads_h

#include "shapetonInterruption.h"

#include <pybind11/pybind11.h>

/** Python's lock (the GIL), which functions of the library release, and what stops them: signals, and the end of the
 * interpreter. */
namespace shapeton::python
{
namespace py = pybind11;

/** \class WithGil
 * \brief Holds Python's lock in a block.
 *
 * A thread that asks for the lock after the interpreter has ended waits for ever, as in Python 3.14. Older versions end
 * the thread by unwinding it, which libraries in C++ answer by aborting the process. */
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

/** \class WithoutGil
 * \brief Lets other threads of Python run while a function of the library does, and signals stop it.
 *
 * When the interpreter ends, functions in other threads stop with SystemExit, and it waits for them: the threads of ITK
 * that work for them must not outlive ITK. */
class WithoutGil
{
public:
  WithoutGil();

private:
  /** Counts the functions that run. */
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

/** Functions about threads, and what is done at the end of the interpreter. */
void
AddThreads(py::module_ & module);
} // namespace shapeton::python

#endif
