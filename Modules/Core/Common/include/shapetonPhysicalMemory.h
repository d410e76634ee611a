#ifndef shapetonPhysicalMemory_h
#define shapetonPhysicalMemory_h

#include <unistd.h>

namespace shapeton
{
/** Physical memory of the machine in bytes. \ingroup ShapetonCommon */
inline double
PhysicalMemory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}
} // namespace shapeton

#endif
