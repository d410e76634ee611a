#include "shapetonFileBytes.h"
#include "shapetonFileErrors.h"

#include <cerrno>
#include <cstdio>
#include <memory>

namespace shapeton
{
std::string
ReadFileBytes(const std::string & path)
{
  const std::unique_ptr<FILE, int (*)(FILE *)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
  if (!file)
  {
    ThrowCannotRead(path, errno);
  }
  std::string bytes;
  char        buffer[1 << 16];
  std::size_t number = 0;
  while ((number = std::fread(buffer, 1, sizeof(buffer), file.get())) > 0)
  {
    bytes.append(buffer, number);
  }
  if (std::ferror(file.get()))
  {
    ThrowCannotRead(path, errno);
  }
  return bytes;
}

void
WriteFileBytes(const std::string & path, const std::string & bytes)
{
  FILE * const file = std::fopen(path.c_str(), "wbe");
  if (!file)
  {
    ThrowCannotWrite(path, errno);
  }
  const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
  const int  error = errno;
  const bool isClosed = std::fclose(file) == 0;
  if (!isWritten || !isClosed)
  {
    ThrowCannotWrite(path, isWritten ? errno : error);
  }
}
} // namespace shapeton
