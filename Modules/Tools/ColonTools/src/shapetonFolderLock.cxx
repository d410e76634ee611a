#include "shapetonFolderLock.h"

#include "shapetonExceptions.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace shapeton
{
// Children inherit the descriptor intentionally: the lock is held while any child runs.
StagedRun::Lock::Lock(const std::string & folder)
  : m_Descriptor(open((folder + "/.lock").c_str(), O_RDWR | O_CREAT, 0666))
{
  if (m_Descriptor < 0)
  {
    throw OutputError("cannot write to the folder \"" + folder + "\" (" + std::strerror(errno) +
                      "); choose another one");
  }
  constexpr int tries = 30; // attempts, 0.1 s apart; lets a tool remove its temporary files
  for (int i = 0; flock(m_Descriptor, LOCK_EX | LOCK_NB) != 0; ++i)
  {
    if (errno != EINTR && (errno != EWOULDBLOCK || i >= tries))
    {
      const bool isBusy = errno == EWOULDBLOCK;
      close(m_Descriptor);
      throw OutputError(isBusy ? "another run is using the folder \"" + folder + "\"; wait for it or choose another one"
                               : "the folder \"" + folder + "\" cannot be locked; choose one on another disk");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

StagedRun::Lock::~Lock() { close(m_Descriptor); }
} // namespace shapeton
