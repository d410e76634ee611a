#ifndef FuzzTrial_h
#define FuzzTrial_h

#include "shapetonExceptions.h"

#include <chrono>
#include <functional>
#include <string>
#include <sys/types.h>

/** Whether a reader accepts its input; it may reject it only with an InputError. */
template <typename TRead>
bool
IsRead(const TRead & read)
{
  try
  {
    read();
    return true;
  }
  catch (const shapeton::InputError &)
  {
    return false;
  }
}

/** Effect of a mutant on the readers. */
struct FuzzOutcome
{
  enum class Kind
  {
    read,
    refused,
    /** A crash, a sanitizer's report, an exception other than InputError, or too much time or memory. */
    fault
  };
  Kind        kind{ Kind::fault };
  std::string reason;
  /** Name of the third-party library that crashed inside its contained process; empty if none did. */
  std::string contained;
};

/** Processes a mutant in a child process with time and memory limits. */
class FuzzTrial
{
public:
  /** Reads the mutant at `path` in the child process. Returns true if it was read, false if it was rejected with an
   * InputError; any other exception is a fault. */
  using Reader = std::function<bool(const std::string & path)>;

  /** Starts the child process for at most `limit`; `path` is removed at the end unless the outcome is a fault. */
  FuzzTrial(const std::string & path, const std::string & log, const Reader & reader, std::chrono::seconds limit);

  /** True if the child has ended or was killed. */
  bool
  HasEnded();

  const FuzzOutcome &
  GetOutcome() const
  {
    return m_Outcome;
  }
  const std::string &
  GetPath() const
  {
    return m_Path;
  }

private:
  void
  Judge(int status, long peakKilobytes);

  std::string                           m_Path;
  std::string                           m_Log;
  pid_t                                 m_Child{ -1 };
  std::chrono::steady_clock::time_point m_Start;
  std::chrono::seconds                  m_Limit;
  bool                                  m_IsOutOfTime{ false };
  FuzzOutcome                           m_Outcome;
};
#endif
