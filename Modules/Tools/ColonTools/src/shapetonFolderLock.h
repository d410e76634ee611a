#ifndef shapetonFolderLock_h
#define shapetonFolderLock_h

#include "shapetonOperatingSystem.h"
#include "shapetonStagedRun.h"

namespace shapeton
{
/** Exclusive lock on a folder, held as long as this object or a child process started during its lifetime exists. */
class StagedRun::Lock
{
public:
  /** Waits a few seconds for a child of a killed run. Throws OutputError. */
  explicit Lock(const std::string & folder);

private:
  FileDescriptor m_File; // children inherit it, so the lock is held while any child runs
};
} // namespace shapeton

#endif
