#ifndef shapetonStartBeside_h
#define shapetonStartBeside_h

#include "ShapetonCommonExport.h"

#include <functional>
#include <future>

namespace shapeton
{
/** Starts a task on its own thread if ITK's settings allow two threads; else the task runs when it is waited for. get()
 * waits and rethrows the exception of the task; without get(), the destructor waits for a task that has started. The
 * thread does not belong to ITK's pool, and pool loops never wait for it; it must not start a ContainedProcess (see
 * there). It uses the Interruption of the starting thread, which must outlive the task.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::future<void>
            StartBeside(std::function<void()> work);
} // namespace shapeton

#endif
