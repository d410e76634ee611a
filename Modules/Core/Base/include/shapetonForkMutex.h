#ifndef shapetonForkMutex_h
#define shapetonForkMutex_h

#include "BaseExport.h"

#include <mutex>

namespace shapeton
{
/** To be held over each fork(): before one, ITK's threader joins the threads of its pool, and after it starts them
 * again; two at a time crash or never end. Hold it also while the ends of a channel that the child must not inherit
 * from another thread are open. \ingroup Base */
Base_EXPORT std::mutex &
            ForkMutex();
} // namespace shapeton

#endif
