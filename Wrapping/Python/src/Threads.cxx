#include "Threads.h"
#include "Timer.h"

#include "shapetonOperatingSystem.h"
#include "shapetonOptions.h"
#include "shapetonParallelFor.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include <cxxabi.h>

namespace shapeton::python
{
using namespace pybind11::literals;

namespace
{
std::atomic<int>             runningCalls{ 0 };
std::atomic<std::thread::id> endingThread{ std::thread::id() }; // the finalizing thread

/** Stop flag for the functions called by a thread. */
struct StopFlag
{
  std::atomic<bool> isSet{ false };
};
thread_local std::shared_ptr<const StopFlag> stopFlag;

/** Whether the interpreter is shutting down or finalized; then only the finalizing thread can get the GIL. */
bool
IsEnding()
{
  return Py_IsInitialized() == 0;
}

/** Throws SystemExit in a thread that must stop, and at shutdown in all threads except the finalizing one, which may
 * still compute. Call it with the GIL held. */
void
StopWhereAsked()
{
  if (IsEnding()) // this thread holds the GIL, so it is the finalizing thread
  {
    endingThread = std::this_thread::get_id();
  }
  const std::thread::id ending = endingThread;
  const bool            isAtTheEnd = ending != std::thread::id() && ending != std::this_thread::get_id();
  if (isAtTheEnd || (stopFlag != nullptr && stopFlag->isSet))
  {
    PyErr_SetNone(PyExc_SystemExit); // ends a Python thread silently
    throw py::error_already_set();
  }
}

/** Called at interpreter shutdown, when threads can still get the GIL. */
void
StopCalls()
{
  constexpr std::chrono::seconds longest(10); // a progress function may block
  endingThread = std::this_thread::get_id();
  const py::gil_scoped_release release;
  Timer                        timer(longest);
  timer.IsOver(); // starts the period
  while (runningCalls > 0 && !timer.IsOver())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/** Called by Interruption: checks signals fifty times a second. */
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
    std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

/** Calls a function that acquires the GIL, if that is still possible. */
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
  catch (abi::__forced_unwind &) // the interpreter was finalized in the meantime
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
  module.def("set_threads", [all = NumberOfThreads()](int number) {
    OptionInfo("number").AtLeast(0.0, "0").AtMost(128.0, "128").Check(number);
    SetNumberOfThreads(number > 0 ? static_cast<unsigned int>(number) : all);
  });
  module.def("threads", &NumberOfThreads);
  py::class_<StopFlag, std::shared_ptr<StopFlag>>(module, "_StopFlag", "Stops the functions called by a thread.")
    .def(py::init<>())
    .def("set", [](StopFlag & flag) { flag.isSet = true; })
    .def("is_set", [](const StopFlag & flag) { return flag.isSet.load(); })
    .def(
      "obey",
      [](const std::shared_ptr<StopFlag> & flag) { stopFlag = flag; },
      "Functions called by this thread from now on end with SystemExit soon after the flag is set.");
  endingThread = std::thread::id(); // a new interpreter may be initialized after shutdown
  py::module_::import("atexit").attr("register")(py::cpp_function(&StopCalls));
  CallAfterFork([] { runningCalls = 0; }); // a child process has no other threads
}
} // namespace shapeton::python
