#ifndef shapetonHelperThreads_h
#define shapetonHelperThreads_h

#include <functional>
#include <memory>

namespace shapeton
{
/** Runs tasks on the threads of a library. */
class HelperThreads
{
public:
  virtual ~HelperThreads() = default;

  virtual const char *
  NameOfLibrary() const = 0;

  /** Allows the process `threads` threads, the calling one included. */
  virtual void
  SetLimit(unsigned int threads) = 0;

  /** Runs `task`, which must not throw, on a free thread; fewer tasks than the limit are requested at a time. */
  virtual void
  Run(const std::function<void()> & task) = 0;
};

/** The threads of ITK's pool, which a forked process can use, too. */
std::unique_ptr<HelperThreads>
MakeItkThreads();

/** The threads of oneTBB, or of ITK's pool if Shapeton was built without oneTBB. */
std::unique_ptr<HelperThreads>
MakeThreads();
} // namespace shapeton

#endif
