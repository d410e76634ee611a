#ifndef shapetonContainedProcess_h
#define shapetonContainedProcess_h

#include "BaseExport.h"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <sys/types.h>

namespace shapeton
{
/** \class ContainedProcess
 * \brief A forked child that works on untrusted bytes, with limits on memory and time.
 *
 * The parsers and decoders of DCMTK, GDCM, NrrdIO and nifti are not ours to trust: a malformed file may crash them,
 * make them loop, or make them ask for all memory. They run in the child; a death there is an ordinary error here.
 *
 * A request and its response are byte strings over a socket; bulk data (pixels) come back in a memory block that both
 * processes see. The child has one thread, prints nothing, and dies with its parent.
 *
 * Make and call it while no other thread works on ITK's pool: both may fork. Before a fork ITK's threader joins the
 * threads of the pool, and a child that inherits the locked pool hangs.
 *
 * \ingroup Base */
class Base_EXPORT ContainedProcess
{
public:
  struct Limits
  {
    /** What the child may allocate on top of what the parent has. */
    std::size_t memoryBytes;
    /** Computing time of one request. */
    unsigned int cpuSeconds;
    /** Elapsed time of one request; generous, for slow network drives. */
    unsigned int wallSeconds;
  };

  /** Works on one request in the child; may write `sharedBytes` bytes to `shared`. An exception becomes a Failure with
   * its message in the parent, and the child lives on. */
  using Service = std::function<std::string(const std::string & request, char * shared)>;

  /** The child died, ran out of time or memory, or reported an error; the message completes "FILE: ...". */
  struct Base_EXPORT Failure : public std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  ContainedProcess(Service service, std::size_t sharedBytes, const Limits & limits);
  ~ContainedProcess();
  ContainedProcess(const ContainedProcess &) = delete;
  ContainedProcess &
  operator=(const ContainedProcess &) = delete;

  /** Sends a request and waits for the response; throws Failure. A child that is gone is started again. */
  std::string
  Call(const std::string & request);

  const char *
  GetShared() const
  {
    return m_Shared;
  }

  /** Stops and starts the child again; called for a child whose state is not to be trusted any more. */
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
