#ifndef shapetonStartBeside_h
#define shapetonStartBeside_h

#include "ShapetonCommonExport.h"

#include <functional>
#include <future>

namespace shapeton
{
/** Starts a task on a separate thread if ITK's settings allow two threads; otherwise get() runs the task. get() waits
 * and rethrows the exception of the task; without get(), the destructor waits for a started task. The thread is not
 * part of ITK's pool, and pool loops never wait for it. It uses the Interruption of the starting thread, which must
 * outlive the task.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::future<void>
                      StartBeside(std::function<void()> work);
} // namespace shapeton

#endif
