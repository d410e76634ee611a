#include "shapetonOperatingSystem.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

namespace shapeton
{
namespace
{
int
OpenUnnamedMemory()
{
#ifdef __linux__
  const int descriptor = memfd_create("shapeton", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (descriptor >= 0)
  {
    fcntl(descriptor, F_ADD_SEALS, F_SEAL_SHRINK); // the other process could crash the owner by truncating it
  }
  return descriptor;
#else
  static std::atomic<unsigned int> next{ 0 };
  const std::string                name = "/shapeton-" + std::to_string(getpid()) + "-" + std::to_string(next++);
  const int descriptor = shm_open(name.c_str(), O_RDWR | O_CREAT | O_EXCL, 0600); // not inherited by programs
  shm_unlink(name.c_str());
  return descriptor;
#endif
}
} // namespace

SharedMemory::SharedMemory() : m_Descriptor(OpenUnnamedMemory())
{
  if (m_Descriptor.Get() < 0)
  {
    throw std::runtime_error(std::string("cannot create shared memory: ") + std::strerror(errno));
  }
}

SharedMemory::~SharedMemory() { this->Unmap(); }

void
SharedMemory::Grow(std::size_t bytes)
{
  if (ftruncate(m_Descriptor.Get(), static_cast<off_t>(bytes)) != 0)
  {
    throw std::bad_alloc();
  }
  this->Map(bytes);
}

void
SharedMemory::Map(std::size_t bytes)
{
  this->Unmap();
  if (bytes == 0)
  {
    return;
  }
  void * const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, m_Descriptor.Get(), 0);
  if (memory == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  m_Data = static_cast<char *>(memory);
  m_Size = bytes;
}

void
SharedMemory::Unmap()
{
  if (m_Data)
  {
    munmap(m_Data, m_Size);
  }
  m_Data = nullptr;
  m_Size = 0;
}
} // namespace shapeton
