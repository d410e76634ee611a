#ifndef shapetonStartBeside_h
#define shapetonStartBeside_h

#include "BaseExport.h"

#include <functional>
#include <future>

namespace shapeton
{
/** Starts a work on a thread of its own, where ITK's settings allow two; else it is done when it is waited for. Wait
 * for it by get(), which throws what the work has thrown; without get(), the destructor waits for one that has begun.
 * Such a thread is none of ITK's pool, and loops of the pool never wait for it; it must not start a ContainedProcess,
 * see there. It asks the Interruption of the thread that started it, which must outlive the work.
 * \ingroup Base */
Base_EXPORT std::future<void>
            StartBeside(std::function<void()> work);
} // namespace shapeton

#endif
