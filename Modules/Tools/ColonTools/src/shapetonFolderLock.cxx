#include "shapetonFolderLock.h"

#include "shapetonExceptions.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

namespace shapeton
{
StagedRun::Lock::Lock(const std::string & folder) : m_File(OpenLockFile(folder + "/.lock"))
{
  if (m_File.Get() < 0)
  {
    throw OutputError("cannot write to the folder \"" + folder + "\" (" + std::strerror(errno) +
                      "); choose another one");
  }
  constexpr int tries = 30; // attempts, 0.1 s apart; lets a tool remove its temporary files
  for (int i = 0, error = TryLock(m_File); error != 0; ++i, error = TryLock(m_File))
  {
    if (error != EINTR && (error != EWOULDBLOCK || i >= tries))
    {
      throw OutputError(error == EWOULDBLOCK
                          ? "another run is using the folder \"" + folder + "\"; wait for it or choose another one"
                          : "the folder \"" + folder + "\" cannot be locked; choose one on another disk");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}
} // namespace shapeton
