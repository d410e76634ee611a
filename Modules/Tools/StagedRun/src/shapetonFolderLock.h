#ifndef shapetonFolderLock_h
#define shapetonFolderLock_h

#include "shapetonStagedRun.h"

namespace shapeton
{
/** While it lives, and while a child that was started meanwhile lives, no other one of the same folder can be made. */
class StagedRun::Lock
{
public:
  /** Waits some seconds for a child of a killed run. Throws OutputError. */
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
