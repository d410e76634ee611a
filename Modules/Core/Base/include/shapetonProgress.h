#ifndef shapetonProgress_h
#define shapetonProgress_h

#include "shapetonInterruption.h"

#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace shapeton
{
/** \class Progress
 * \brief Receives how far a piece of work has come; every long function of Shapeton takes one.
 *
 * A copyable value that holds a function of the stage in words and the share of the whole that is done, from 0 to 1, or
 * a function of the share alone, or nothing. It is called from the thread that called the work. The function may throw
 * in order to abort the work; the exception reaches the caller. A report asks Interruption first.
 *
 * \code
 * options.progress = [&](const std::string & stage, double share) { std::cout << stage << ' ' << share << '\n'; };
 * \endcode
 *
 * \ingroup Base */
class Progress
{
public:
  Progress() = default;

  template <typename TFunction,
            typename = std::enable_if_t<std::is_invocable_v<TFunction, double> ||
                                        std::is_invocable_v<TFunction, const std::string &, double>>,
            typename = std::enable_if_t<!std::is_same_v<std::decay_t<TFunction>, Progress>>>
  Progress(TFunction function)
  {
    if constexpr (std::is_invocable_v<TFunction, double>)
    {
      m_Function = [function = std::move(function)](const std::string &, double share) { function(share); };
    }
    else
    {
      m_Function = std::move(function);
    }
  }

  /** Reports the stage and the share of the whole. */
  void
  operator()(const std::string & stage, double share) const
  {
    Interruption::Check();
    if (m_Function)
    {
      m_Function(stage, share);
    }
  }

  /** Reports the share of work that has one stage alone. */
  void
  operator()(double share) const
  {
    (*this)(std::string(), share);
  }

  /** The receiver for a part of the work, which is known to the whole as `stage` and fills [begin, end] of it. */
  Progress
  Part(const std::string & stage, double begin, double end) const
  {
    Progress part;
    if (m_Function)
    {
      part.m_Function = [whole = m_Function, stage, begin, end](const std::string &, double share) {
        whole(stage, begin + share * (end - begin));
      };
    }
    return part;
  }

private:
  std::function<void(const std::string &, double)> m_Function;
};
} // namespace shapeton

#endif
