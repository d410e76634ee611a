#ifndef itkPhysicalMemory_h
#define itkPhysicalMemory_h

#include <unistd.h>

namespace itk
{
/** Bytes of the machine's memory. \ingroup Base */
inline double
PhysicalMemory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}
} // namespace itk

#endif
