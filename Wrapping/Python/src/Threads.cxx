#include "Threads.h"
#include "Timer.h"

#include "itkMultiThreaderBase.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include <cxxabi.h>
#include <pthread.h>
#include <unistd.h>

namespace shapeton::python
{
using namespace pybind11::literals;

namespace
{
std::atomic<int>             runningCalls{ 0 };
std::atomic<std::thread::id> endingThread{ std::thread::id() }; // which ends the interpreter

/** Tells the functions that a thread calls to stop. */
struct StopFlag
{
  std::atomic<bool> isSet{ false };
};
thread_local std::shared_ptr<const StopFlag> stopFlag;

/** Whether the interpreter ends or has ended: only the thread that ends it can have Python's lock. */
bool
IsEnding()
{
  return Py_IsInitialized() == 0;
}

/** Throws SystemExit in a thread that is to stop, and at the end in threads other than the one that ends the
 * interpreter, which may still compute. To be called with the GIL held. */
void
StopWhereAsked()
{
  if (IsEnding()) // this thread has the lock, so it is the one that ends the interpreter
  {
    endingThread = std::this_thread::get_id();
  }
  const std::thread::id ending = endingThread;
  const bool            isAtTheEnd = ending != std::thread::id() && ending != std::this_thread::get_id();
  if (isAtTheEnd || (stopFlag != nullptr && stopFlag->isSet))
  {
    PyErr_SetNone(PyExc_SystemExit); // ends a thread of Python without a word
    throw py::error_already_set();
  }
}

/** Called at the end of the interpreter, when threads can still have the GIL. */
void
StopCalls()
{
  constexpr std::chrono::seconds longest(10); // a function of Python that reports call may wait for something else
  endingThread = std::this_thread::get_id();
  const py::gil_scoped_release release;
  Timer                        timer(longest);
  timer.IsOver(); // begins the period
  while (runningCalls > 0 && !timer.IsOver())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/** What Interruption calls: looks at signals fifty times a second. */
std::function<void()>
StopCheck()
{
  return [timer = Timer(std::chrono::milliseconds(20))]() mutable {
    if (!timer.IsOver())
    {
      return;
    }
    const WithGil gil;
    StopWhereAsked();
    if (PyErr_CheckSignals() != 0)
    {
      throw py::error_already_set();
    }
  };
}

[[noreturn]] void
WaitForEver()
{
  for (;;)
  {
    pause();
  }
}

/** Calls a function that takes Python's lock, if that can still be had. */
template <typename TTake>
auto
TakeGil(const TTake & take)
{
  if (IsEnding() && endingThread != std::this_thread::get_id())
  {
    WaitForEver();
  }
  try
  {
    return take();
  }
  catch (abi::__forced_unwind &) // the interpreter has ended meanwhile
  {
    WaitForEver();
  }
}
} // namespace

WithGil::WithGil() : m_State(TakeGil([] { return PyGILState_Ensure(); })) {}

WithGil::~WithGil() { PyGILState_Release(m_State); }

std::shared_ptr<PyObject>
Share(py::object object)
{
  return { object.release().ptr(), [](PyObject * shared) {
            if (!IsEnding())
            {
              const WithGil gil;
              Py_DECREF(shared);
            }
          } };
}

WithoutGil::Call::Call()
{
  StopWhereAsked();
  ++runningCalls;
}

WithoutGil::Call::~Call() { --runningCalls; }

WithoutGil::Released::Released() : m_State(PyEval_SaveThread()) {}

WithoutGil::Released::~Released()
{
  TakeGil([this] { PyEval_RestoreThread(m_State); });
}

WithoutGil::WithoutGil() : m_Interruption(StopCheck()) {}

void
AddThreads(py::module_ & module)
{
  module.def(
    "set_threads",
    [](unsigned int number) { itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(number); },
    "number"_a,
    "Sets the number of threads of all functions of this process; results do not depend on it.");
  module.def("threads",
             &itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads,
             "The number of threads of all functions of this process.");
  py::class_<StopFlag, std::shared_ptr<StopFlag>>(module, "_StopFlag", "Stops the functions called by a thread.")
    .def(py::init<>())
    .def("set", [](StopFlag & flag) { flag.isSet = true; })
    .def("is_set", [](const StopFlag & flag) { return flag.isSet.load(); })
    .def(
      "obey",
      [](const std::shared_ptr<StopFlag> & flag) { stopFlag = flag; },
      "Functions called by this thread from now on end with SystemExit soon after the flag is set.");
  endingThread = std::thread::id(); // an interpreter may begin after another one
  py::module_::import("atexit").attr("register")(py::cpp_function(&StopCalls));
  pthread_atfork(nullptr, nullptr, [] { runningCalls = 0; }); // a child has no other threads
}
} // namespace shapeton::python
