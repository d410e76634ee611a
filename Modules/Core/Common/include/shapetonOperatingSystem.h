#ifndef shapetonOperatingSystem_h
#define shapetonOperatingSystem_h

#include "ShapetonCommonExport.h"

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** \defgroup OperatingSystem The functions of POSIX systems that the C++ library lacks
 * Only `src/posix` of this module includes POSIX headers.
 * \ingroup ShapetonCommon */
///@{

/** \class FileDescriptor
 * \brief An open descriptor, closed on destruction. \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT FileDescriptor
{
public:
  explicit FileDescriptor(int number = -1) : m_Number(number) {}
  FileDescriptor(FileDescriptor && other) noexcept : m_Number(std::exchange(other.m_Number, -1)) {}
  FileDescriptor &
  operator=(FileDescriptor && other) noexcept
  {
    std::swap(m_Number, other.m_Number);
    return *this;
  }
  ~FileDescriptor();

  int
  Get() const
  {
    return m_Number;
  }

private:
  int m_Number;
};

/** \class MessageChannel
 * \brief One end of a connection between two processes that exchange messages: a kind and a byte string.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT MessageChannel
{
public:
  using Clock = std::chrono::steady_clock;

  enum class Transfer
  {
    complete,
    /** The other end was closed. */
    ended,
    outOfTime,
    tooLarge
  };

  explicit MessageChannel(FileDescriptor end = FileDescriptor()) : m_End(std::move(end)) {}

  /** Two connected ends, which programs started by this process do not inherit. Throws std::runtime_error. */
  static std::pair<MessageChannel, MessageChannel>
  MakePair();

  int
  GetDescriptor() const
  {
    return m_End.Get();
  }

  /** Whether the descriptor is one end of a connection. */
  bool
  IsConnected() const;

  /** Returns false if the other end is closed. */
  bool
  Send(char kind, const std::string & text) const;

  Transfer
  Receive(char & kind, std::string & text, Clock::time_point deadline, std::size_t maximumBytes) const;

private:
  Transfer
  ReceiveAll(char * data, std::size_t size, Clock::time_point deadline) const;

  FileDescriptor m_End;
};

/** \class SharedMemory
 * \brief Memory shared by two processes, without a name in any file system, so nothing remains after a crash.
 *
 * The owner creates it empty and grows it; the other process constructs it from the inherited descriptor and maps it.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT SharedMemory
{
public:
  /** Creates empty memory; throws std::runtime_error. */
  SharedMemory();
  /** Memory created by another process. */
  explicit SharedMemory(FileDescriptor descriptor) : m_Descriptor(std::move(descriptor)) {}
  ~SharedMemory();
  SharedMemory(const SharedMemory &) = delete;
  SharedMemory &
  operator=(const SharedMemory &) = delete;

  /** Sets the size of new memory and maps it; throws std::bad_alloc. Some systems allow this only once. */
  void
  Grow(std::size_t bytes);

  /** Maps memory of this size; throws std::bad_alloc. */
  void
  Map(std::size_t bytes);

  int
  GetDescriptor() const
  {
    return m_Descriptor.Get();
  }
  /** Null for empty memory. */
  char *
  GetData() const
  {
    return m_Data;
  }
  std::size_t
  GetSize() const
  {
    return m_Size;
  }

private:
  void
  Unmap();

  FileDescriptor m_Descriptor;
  char *         m_Data{ nullptr };
  std::size_t    m_Size{ 0 };
};

/** \class ChildProcess
 * \brief A program started by this process; killed on destruction. \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT ChildProcess
{
public:
  /** How a process ended. */
  struct End
  {
    bool isSignal{ false };
    /** The signal or the exit status; -1 if unknown. */
    int number{ -1 };
  };

  ChildProcess() = default;
  /** Starts a program, which inherits the standard streams, and the given descriptors as 3, 4, and so on. Interrupts
   * from the keyboard (SIGINT) do not reach it. Threads of this process may run. Throws std::runtime_error. */
  ChildProcess(const std::string &              program,
               const std::vector<std::string> & arguments,
               const std::vector<int> &         descriptors);
  ChildProcess(ChildProcess && other) noexcept : m_Number(std::exchange(other.m_Number, -1)) {}
  ChildProcess &
  operator=(ChildProcess && other) noexcept
  {
    std::swap(m_Number, other.m_Number);
    return *this;
  }
  ~ChildProcess();

  bool
  IsRunning() const
  {
    return m_Number >= 0;
  }

  /** Waits until it ends. */
  End
  Wait();

  /** Kills it and waits. */
  void
  Kill();

private:
  int m_Number{ -1 };
};

/** The first descriptor that ChildProcess passes to a program. */
constexpr int FirstInheritedDescriptor = 3;

/** The number of this process. */
ShapetonCommon_EXPORT int
ProcessNumber();

/** Kills this process when the thread that started it ends (on Linux). Returns false if its parent is not the given
 * process, which has then ended. */
ShapetonCommon_EXPORT bool
EndWithParent(int parent);

/** Discards output printed by libraries and disables core dumps; the address sanitizer still reports. */
ShapetonCommon_EXPORT void
SilenceThisProcess();

/** \class MemoryLimit
 * \brief Limits the memory that this process may allocate in addition to its size at construction.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT MemoryLimit
{
public:
  MemoryLimit();
  /** Allows `privateBytes` of its own memory and `sharedBytes` of mapped SharedMemory. */
  void
  Set(std::size_t privateBytes, std::size_t sharedBytes) const;

private:
  std::size_t m_TotalBytes;
  std::size_t m_DataBytes;
};

/** Ends this process after this many further seconds of CPU time. */
ShapetonCommon_EXPORT void
LimitComputingTime(unsigned int seconds);

/** Whether a process that ended in this way exceeded its CPU time, or was killed. */
ShapetonCommon_EXPORT bool
WasOutOfComputingTime(const ChildProcess::End & end);

/** The folder of the shared library or program that contains this function, without symbolic links. */
ShapetonCommon_EXPORT std::string
                      FolderOfThisLibrary();
///@}
} // namespace shapeton

#endif
