#include "shapetonFaultySystem.h"

#include <cerrno>
#include <csignal>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tooltest
{
FaultySystem faultySystem;
} // namespace tooltest

using tooltest::faultySystem;

// Functions of the program override library functions of the same name, also in calls from libraries.
extern "C" __attribute__((visibility("default"))) int
fsync(int descriptor) noexcept(noexcept(::fsync(0)))
{
  if (faultySystem.fsyncError)
  {
    errno = faultySystem.fsyncError;
    return -1;
  }
  static const auto system = reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "fsync"));
  return system(descriptor);
}

extern "C" __attribute__((visibility("default"))) int
rename(const char * from, const char * to) noexcept
{
  static int calls = 0;
  if (++calls == faultySystem.callOfRename)
  {
    if (faultySystem.signalAtRename)
    {
      raise(faultySystem.signalAtRename);
    }
    if (faultySystem.renameError)
    {
      errno = faultySystem.renameError;
      return -1;
    }
  }
  static const auto system = reinterpret_cast<int (*)(const char *, const char *)>(dlsym(RTLD_NEXT, "rename"));
  return system(from, to);
}

extern "C" __attribute__((visibility("default"))) int
mkdir(const char * path, mode_t mode) noexcept
{
  static const auto system = reinterpret_cast<int (*)(const char *, mode_t)>(dlsym(RTLD_NEXT, "mkdir"));
  if (faultySystem.losesRaceForFolder)
  {
    system(path, mode);
  }
  return system(path, mode);
}
