#ifndef shapetonContainedProcess_h
#define shapetonContainedProcess_h

#include "ShapetonCommonExport.h"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <sys/types.h>

namespace shapeton
{
/** \class ContainedProcess
 * \brief A forked child process that parses untrusted bytes, with limits on memory and time.
 *
 * A malformed file may crash the parsers of DCMTK, GDCM, NrrdIO and nifti, make them loop forever, or make them
 * allocate all memory. They therefore run in the child, whose crash becomes an ordinary error here.
 *
 * A request and its response are byte strings over a socket; bulk data (pixels) are returned in a shared memory block.
 * The child has one thread, prints nothing, and is killed when its parent exits.
 *
 * Construct and call it only while no other thread uses ITK's thread pool: construction and calls may fork, ITK's
 * threader joins the pool's threads before a fork, and a child that inherits the locked pool hangs.
 *
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT ContainedProcess
{
public:
  struct Limits
  {
    /** Memory that the child may allocate in addition to the parent. */
    std::size_t memoryBytes;
    /** CPU time limit of one request. */
    unsigned int cpuSeconds;
    /** Wall-clock time limit of one request; generous, for slow network drives. */
    unsigned int wallSeconds;
  };

  /** Handles one request in the child; may write `sharedBytes` bytes to `shared`. An exception is rethrown in the
   * parent as a Failure with the same message, and the child keeps running. */
  using Service = std::function<std::string(const std::string & request, char * shared)>;

  /** The child crashed, exceeded its limits, or reported an error; the message completes "FILE: ...". */
  struct ShapetonCommon_EXPORT Failure : public std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  ContainedProcess(Service service, std::size_t sharedBytes, const Limits & limits);
  ~ContainedProcess();
  ContainedProcess(const ContainedProcess &) = delete;
  ContainedProcess &
  operator=(const ContainedProcess &) = delete;

  /** Sends a request and waits for the response; throws Failure. Restarts the child if it has died. */
  std::string
  Call(const std::string & request);

  const char *
  GetShared() const
  {
    return m_Shared;
  }

  /** Kills the child and starts a new one, for example after the child became unreliable. */
  void
  Stop();

private:
  void
  Start();
  std::string
  Receive();
  [[noreturn]] void
  ReportDeath(bool outOfTime);
  [[noreturn]] void
  Serve(int channel) const;

  Service     m_Service;
  std::size_t m_SharedBytes;
  Limits      m_Limits;
  char *      m_Shared{ nullptr };
  int         m_Channel{ -1 };
  pid_t       m_Child{ -1 };
};
} // namespace shapeton

#endif
