#include "Options.h"

namespace shapeton::python
{
std::size_t
PositionOf(const std::string & word, const OptionInfo & info)
{
  const auto & words = info.GetWords();
  const auto   found = std::find(words.begin(), words.end(), word);
  std::string  list;
  for (const char * one : words)
  {
    list += (list.empty() ? "" : ", ") + std::string(one);
  }
  RequireParameter(found != words.end(),
                   "the parameter \"" + std::string(info.GetName()) + "\" = \"" + word + "\" is not one of: " + list);
  return static_cast<std::size_t>(found - words.begin());
}
} // namespace shapeton::python
