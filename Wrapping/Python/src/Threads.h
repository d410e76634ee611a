#ifndef Threads_h
#define Threads_h

#include "shapetonInterruption.h"

#include <pybind11/pybind11.h>

#include <memory>

/** Python's lock (the GIL), which functions of the library release, and what stops them: signals, and the end of the
 * interpreter. */
namespace shapeton::python
{
namespace py = pybind11;

/** \class WithGil
 * \brief Holds Python's lock in a block.
 *
 * From the end of the interpreter on, only the thread that ends it gets the lock. Any other thread that asks for it
 * waits for ever, as in Python 3.14. Older versions end the thread by unwinding it, which libraries in C++ answer by
 * aborting the process. No destructor of an object that Python keeps may use this class: see Share(). */
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

/** Shares a Python object with C++ code, which may drop it in any thread and at any time. Objects that hold such a
 * reference may live until the process ends, for example in a global of a module. So the reference is given back while
 * the interpreter is alive, and kept for ever from its end on: then most threads would wait for Python's lock in vain,
 * and the memory goes with the process. */
std::shared_ptr<PyObject>
Share(py::object object);

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
