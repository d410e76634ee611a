#include "Options.h"

namespace shapeton::python
{
std::size_t
PositionOf(const std::string & word, const OptionInfo & info)
{
  const auto & words = info.GetWords();
  const auto   found = std::find(words.begin(), words.end(), word);
  std::string  all;
  for (const char * one : words)
  {
    all += (all.empty() ? "\"" : ", \"") + std::string(one) + '"';
  }
  RequireParameter(found != words.end(),
                   "the parameter \"" + std::string(info.GetName()) + "\" = \"" + word + "\": use one of " + all);
  return static_cast<std::size_t>(found - words.begin());
}
} // namespace shapeton::python
