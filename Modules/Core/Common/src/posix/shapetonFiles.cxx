#include "shapetonOperatingSystem.h"

#include <cerrno>
#include <cstdio> // renameat2
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace shapeton
{
int
ErrorOfAccess(const std::string & path, FileAccess access)
{
  const char * const name = path.c_str();
  const bool         isAllowed = access == FileAccess::read        ? ::access(name, R_OK) == 0
                                 : access == FileAccess::overwrite ? faccessat(AT_FDCWD, name, W_OK, AT_EACCESS) == 0
                                 : access == FileAccess::create    ? ::access(name, W_OK | X_OK) == 0
                                                                   : ::access(name, X_OK) == 0;
  return isAllowed ? 0 : errno;
}

int
ErrorOfCreation(const std::string & path)
{
  unlink(path.c_str());
  const FileDescriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (file.Get() < 0)
  {
    return errno;
  }
  unlink(path.c_str());
  return 0;
}

int
ErrorOfSync(const std::string & path)
{
  const FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  return file.Get() >= 0 && fsync(file.Get()) == 0 ? 0 : errno;
}

int
ErrorOfFileSystemSync(const std::string & folder)
{
  const FileDescriptor file(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return file.Get() >= 0 && syncfs(file.Get()) == 0 ? 0 : errno;
}

bool
ExchangeNames(const std::string & first, const std::string & second)
{
  return renameat2(AT_FDCWD, first.c_str(), AT_FDCWD, second.c_str(), RENAME_EXCHANGE) == 0;
}

FileStatus
StatusOf(const std::string & path)
{
  FileStatus  status;
  struct stat found = {};
  if (stat(path.c_str(), &found) != 0)
  {
    status.error = errno;
    return status;
  }
  status.isFolder = S_ISDIR(found.st_mode);
  status.isFile = S_ISREG(found.st_mode);
  status.identity = { found.st_dev, found.st_ino };
  return status;
}

FileDescriptor
OpenLockFile(const std::string & path)
{
  return FileDescriptor(open(path.c_str(), O_RDWR | O_CREAT, 0666));
}

int
TryLock(const FileDescriptor & file)
{
  return flock(file.Get(), LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
}
} // namespace shapeton
