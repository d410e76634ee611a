#ifndef shapetonOperatingSystem_h
#define shapetonOperatingSystem_h

#include "ShapetonCommonExport.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <system_error>
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

/** \class Pipe
 * \brief A pipe from a child process to this one. \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT Pipe
{
public:
  /** Throws std::system_error. */
  Pipe();

  int
  GetInput() const
  {
    return m_Input.Get();
  }
  int
  GetOutput() const
  {
    return m_Output.Get();
  }
  void
  CloseInput()
  {
    m_Input = FileDescriptor();
  }

private:
  FileDescriptor m_Output;
  FileDescriptor m_Input;
};

/** Receives bytes from a pipe. */
using TakePipeBytes = std::function<void(const char * bytes, std::size_t size)>;

/** Reads two pipes until their inputs are closed. */
ShapetonCommon_EXPORT void
ReadPipes(const Pipe & first, const TakePipeBytes & takeFirst, const Pipe & second, const TakePipeBytes & takeSecond);

/** \class ChildProcess
 * \brief A program started by this process; ended by a signal on destruction.
 *
 * On Linux, the program also gets the signal when the thread that started it ends. Other threads may run: the start
 * uses vfork(), because ITK's threader joins the threads of its pool before each fork(), so no other thread could use
 * the pool, and the child could inherit its locks. Therefore Boost.Process, which forks, is not used; posix_spawn()
 * cannot request the signal. \ingroup ShapetonCommon */
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
  ChildProcess(ChildProcess && other) noexcept : m_Number(std::exchange(other.m_Number, -1)), m_Signal(other.m_Signal)
  {}
  ChildProcess &
  operator=(ChildProcess && other) noexcept
  {
    std::swap(m_Number, other.m_Number);
    std::swap(m_Signal, other.m_Signal);
    return *this;
  }
  ~ChildProcess();

  /** Starts a program with an empty standard input and these outputs. The signal is SIGTERM. Throws std::system_error.
   */
  static ChildProcess
  StartTool(const std::string &              program,
            const std::vector<std::string> & arguments,
            const Pipe &                     out,
            const Pipe &                     err);

  /** Starts a program that inherits the standard streams, and the given descriptors as 3, 4, and so on, and no others.
   * The signal is SIGKILL; interrupts from the keyboard (SIGINT) do not reach it. Throws std::system_error. */
  static ChildProcess
  StartIsolated(const std::string &              program,
                const std::vector<std::string> & arguments,
                const std::vector<int> &         descriptors);

  bool
  IsRunning() const
  {
    return m_Number >= 0;
  }

  /** Waits until it ends. */
  End
  Wait();

  /** Sends the signal and waits. */
  void
  Stop();

private:
  ChildProcess(int number, int signal) : m_Number(number), m_Signal(signal) {}

  int m_Number{ -1 };
  int m_Signal{ 0 };
};

/** The first descriptor that ChildProcess::StartIsolated() passes to a program. */
constexpr int FirstInheritedDescriptor = 3;

/** The number of this process. */
ShapetonCommon_EXPORT int
ProcessNumber();

/** Whether a process exists on this machine. */
ShapetonCommon_EXPORT bool
IsProcessAlive(long number);

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

/** Ends this process after this many more seconds of CPU time. */
ShapetonCommon_EXPORT void
LimitComputingTime(unsigned int seconds);

/** Whether a process that ended in this way was killed, as when it exceeds its CPU time. */
ShapetonCommon_EXPORT bool
WasKilled(const ChildProcess::End & end);

/** Calls a function in each process that is forked from this one. */
ShapetonCommon_EXPORT void
CallAfterFork(void (*function)());

/** Path of the program of this process; empty, with an error, if the system does not report it. */
ShapetonCommon_EXPORT std::string
                      PathOfThisProgram(std::error_code & error);

/** A time in UTC, or in the time zone of this machine, in a format of std::strftime(). */
///@{
ShapetonCommon_EXPORT std::string
                      UniversalTimeText(std::time_t time, const char * format);
ShapetonCommon_EXPORT std::string
                      LocalTimeText(std::time_t time, const char * format);
///@}

/** The folder of the shared library or program that contains this function, without symbolic links. */
ShapetonCommon_EXPORT std::string
                      FolderOfThisLibrary();

/** \name Files; errors are values of errno, 0 for none */
///@{
enum class FileAccess
{
  read,
  /** Write as the effective user of this process. */
  overwrite,
  /** Create files in a folder. */
  create,
  execute
};

ShapetonCommon_EXPORT int
ErrorOfAccess(const std::string & path, FileAccess access);

/** Creates a new file and removes it; an existing file is removed first. */
ShapetonCommon_EXPORT int
ErrorOfCreation(const std::string & path);

/** Flushes a file or folder to disk. */
ShapetonCommon_EXPORT int
ErrorOfSync(const std::string & path);

/** Flushes the entire file system that contains a folder to disk. */
ShapetonCommon_EXPORT int
ErrorOfFileSystemSync(const std::string & folder);

/** Exchanges two names atomically; returns false if the file system does not support this. */
ShapetonCommon_EXPORT bool
ExchangeNames(const std::string & first, const std::string & second);

/** What a name, or the target of a link, refers to. */
struct FileStatus
{
  int  error{ 0 };
  bool isFolder{ false };
  bool isFile{ false };
  /** Equal for all names of a file. */
  std::pair<std::uint64_t, std::uint64_t> identity;
};

ShapetonCommon_EXPORT FileStatus
StatusOf(const std::string & path);

/** Opens a file for TryLock() and creates it if necessary; on error, the descriptor is invalid and errno is set.
 * Programs started by this process inherit the descriptor and the lock. */
ShapetonCommon_EXPORT FileDescriptor
OpenLockFile(const std::string & path);

/** Locks a file for this descriptor; EWOULDBLOCK if it is locked by another descriptor, even one of this process. */
ShapetonCommon_EXPORT int
TryLock(const FileDescriptor & file);
///@}

/** \name The machine and the terminal */
///@{
/** Physical memory in bytes. */
ShapetonCommon_EXPORT double
PhysicalMemory();

/** Requests huge pages for a block of memory, if the system has them. */
ShapetonCommon_EXPORT void
RequestHugePages(void * memory, std::size_t bytes);

ShapetonCommon_EXPORT std::string
                      HostName();

/** Whether standard output is a terminal. */
ShapetonCommon_EXPORT bool
IsTerminal();

/** Width of the terminal at standard output; 0 if unknown. */
ShapetonCommon_EXPORT std::size_t
                      TerminalColumns();

/** Reopens standard streams that were closed at start; otherwise an output file could be opened as stdout and receive
 * the progress. */
ShapetonCommon_EXPORT void
OpenMissingStandardStreams();

/** \class QuietStandardError
 * \brief Discards standard error during its lifetime. Instances in several threads may overlap.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT QuietStandardError
{
public:
  QuietStandardError();
  ~QuietStandardError();
  QuietStandardError(const QuietStandardError &) = delete;
  QuietStandardError &
  operator=(const QuietStandardError &) = delete;
};
///@}

/** \name Signals that terminate this process */
///@{
/** \class RemovalAtDeath
 * \brief While it exists, the handlers of termination signals remove the named file or empty folder. The latest
 * instance is processed first. \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT RemovalAtDeath
{
public:
  struct Node;

  /** Installs the handlers. Signals that are already handled or ignored are not changed: SIGHUP under nohup, SIGSEGV
   * under a sanitizer. */
  static void
  InstallHandlers();

  explicit RemovalAtDeath(const std::string & path);
  RemovalAtDeath(RemovalAtDeath && other) noexcept;
  RemovalAtDeath &
  operator=(RemovalAtDeath &&) = delete;
  ~RemovalAtDeath();

private:
  Node * m_Node;
};

/** \class DeathDelay
 * \brief Lets the handlers of RemovalAtDeath defer SIGINT, SIGTERM and similar signals, to avoid termination between
 * two renames. \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT DeathDelay
{
public:
  DeathDelay();
  DeathDelay(const DeathDelay &) = delete;
  DeathDelay &
  operator=(const DeathDelay &) = delete;
  ~DeathDelay();
};

/** \class DeferredSignals
 * \brief Defers SIGINT, SIGTERM and SIGHUP during its lifetime. \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT DeferredSignals
{
public:
  DeferredSignals();
  DeferredSignals(const DeferredSignals &) = delete;
  DeferredSignals &
  operator=(const DeferredSignals &) = delete;
  ~DeferredSignals();

  /** Whether a signal was deferred. */
  static bool
  IsPending();

private:
  void (*m_Previous[3])(int);
};
///@}
///@}
} // namespace shapeton

#endif
