#ifndef shapetonContainedProcess_h
#define shapetonContainedProcess_h

#include "shapetonOperatingSystem.h"

#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

namespace shapeton
{
/** \class ContainedProcess
 * \brief A separate program that parses untrusted bytes, with limits on memory and time.
 *
 * A malformed file may crash the parsers of DCMTK, GDCM, NrrdIO and nifti, make them loop forever, or make them
 * allocate all memory. They therefore run in the program ShapetonFileParser, whose crash becomes an ordinary error
 * here. The program must have the same version as this library. The environment variable SHAPETON_FILE_PARSER may
 * contain its path; otherwise it is searched for relative to this library, then in the installation folder.
 *
 * A request and its response are byte strings over a socket; bulk data (pixels) are returned in a shared memory block.
 * The program prints nothing and ends with its parent. On Linux it also ends with the thread that started it, so use a
 * ContainedProcess in the thread that constructed it. Other threads may run.
 *
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT ContainedProcess
{
public:
  struct Limits
  {
    /** Memory that the program may allocate. */
    std::size_t memoryBytes;
    /** CPU time limit of one request. */
    unsigned int cpuSeconds;
    /** Wall-clock time limit of one request; generous, for slow network drives. */
    unsigned int wallSeconds;
  };

  /** The program crashed, exceeded its limits, or reported an error; the message completes "FILE: ...". */
  struct ShapetonCommon_EXPORT Failure : public std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  /** Starts the program for one of its services. Throws std::runtime_error if it is missing or unsuitable. */
  ContainedProcess(const std::string & service, std::size_t sharedBytes, const Limits & limits);

  /** Sends a request and waits for the response; throws Failure. Restarts the program if it has died. */
  std::string
  Call(const std::string & request);

  /** Sets the size of empty shared memory and the limits of the next requests. */
  void
  Share(std::size_t sharedBytes, const Limits & limits);

  const char *
  GetShared() const
  {
    return m_Shared.GetData();
  }

  /** Kills the program; the next request starts a new one. */
  void
  Stop();

private:
  void
  Start();
  void
  Greet(const std::string & program);
  [[noreturn]] void
  ReportDeath();

  std::string    m_Service;
  Limits         m_Limits;
  SharedMemory   m_Shared;
  MessageChannel m_Channel;
  ChildProcess   m_Child;
};

/** Handles one request; may write to the shared memory of the request. An exception is rethrown in the parent as a
 * ContainedProcess::Failure with the same message, and the program continues. \ingroup ShapetonCommon */
using ContainedService = std::function<std::string(const std::string & request, char * shared)>;

/** Functions that create the services of a program, by name. An exception makes the constructor of ContainedProcess
 * fail. \ingroup ShapetonCommon */
using ContainedServices = std::map<std::string, std::function<ContainedService()>>;

/** \class AddContainedServices
 * \brief A static instance in a program adds services to those that ServeContained() offers.
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT AddContainedServices
{
public:
  explicit AddContainedServices(ContainedServices services);
};

/** The main function of a program that is started by ContainedProcess. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT int
ServeContained(int argc, char * argv[]);
} // namespace shapeton

#endif
