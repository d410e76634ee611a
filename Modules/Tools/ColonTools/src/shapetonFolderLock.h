#ifndef shapetonFolderLock_h
#define shapetonFolderLock_h

#include "shapetonStagedRun.h"

namespace shapeton
{
/** Exclusive lock on a folder, held as long as this object or a child process started during its lifetime exists. */
class StagedRun::Lock
{
public:
  /** Waits a few seconds for a child of a killed run. Throws OutputError. */
  explicit Lock(const std::string & folder);
  Lock(const Lock &) = delete;
  Lock &
  operator=(const Lock &) = delete;
  ~Lock();

private:
  int m_Descriptor;
};
} // namespace shapeton

#endif
