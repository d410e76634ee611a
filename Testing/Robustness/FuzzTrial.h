#ifndef FuzzTrial_h
#define FuzzTrial_h

#include <chrono>
#include <functional>
#include <string>
#include <sys/types.h>

/** What a mutant did to the readers. */
struct FuzzOutcome
{
  enum class Kind
  {
    read,
    refused,
    /** Our fault: a crash, a sanitizer's report, an exception that is no InputError, too much time or memory. */
    fault
  };
  Kind        kind{ Kind::fault };
  std::string reason;
  /** A decoder of another project crashed inside its contained process; the name of its library. */
  std::string contained;
};

/** Work on a mutant in a child, under limits of time and memory. */
class FuzzTrial
{
public:
  /** Reads the mutant at `path`; in the child. Returns true when it was read, false when it was refused by an
   * InputError; any other exception is a fault. */
  using Reader = std::function<bool(const std::string & path)>;

  /** Starts the work, for at most `limit`; `path` is removed at the end unless the outcome is a fault. */
  FuzzTrial(const std::string & path, const std::string & log, const Reader & reader, std::chrono::seconds limit);

  /** True when the child has ended or has been ended. */
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
