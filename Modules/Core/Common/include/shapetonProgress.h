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
 * \brief Progress callback, a parameter of all long-running functions.
 *
 * A copyable wrapper of a function that takes the name of the stage and the completed fraction of the whole, from 0 to
 * 1, or only the fraction. It may be empty. It is called on the thread that started the work. The function may throw to
 * abort the work; the exception propagates to the caller. Each report checks Interruption first.
 *
 * \code
 * options.progress = [&](const std::string & stage, double share) { std::cout << stage << ' ' << share << '\n'; };
 * \endcode
 *
 * \ingroup ShapetonCommon */
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

  /** Reports the stage and the completed fraction of the whole. */
  void
  operator()(const std::string & stage, double share) const
  {
    Interruption::Check();
    if (m_Function)
    {
      m_Function(stage, share);
    }
  }

  /** Reports the completed fraction of work that has a single stage. */
  void
  operator()(double share) const
  {
    (*this)(std::string(), share);
  }

  /** Progress callback for a part of the work, reported as `stage`; the part covers [begin, end] of the whole. */
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
