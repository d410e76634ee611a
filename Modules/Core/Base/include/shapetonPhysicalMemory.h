#ifndef shapetonPhysicalMemory_h
#define shapetonPhysicalMemory_h

#include <unistd.h>

namespace shapeton
{
/** Bytes of the machine's memory. \ingroup Base */
inline double
PhysicalMemory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}
} // namespace shapeton

#endif
